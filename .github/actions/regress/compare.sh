#!/bin/bash
# Compares the study MANIFEST with its baseline, and shows the summary on the page of the job. Exits as mien regress
# does: 0 all is as approved, 1 something differs, 2 no comparison was possible.
set -uo pipefail

rm -rf mien-regression  # of another study in the same job
# shellcheck disable=SC2086 # a word an argument
mien regress "$MANIFEST" --out "$PWD/mien-regression" ${ARGUMENTS:-}
code=$?
for summary in mien-regression/*-regression/summary.md; do
  [[ ! -e $summary ]] || cat "$summary" >>"${GITHUB_STEP_SUMMARY:-/dev/stdout}"
done
exit $code
