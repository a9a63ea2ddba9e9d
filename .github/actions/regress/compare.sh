#!/bin/bash
# Compares the study MANIFEST with its baseline, and shows the summary on the page of the job. Exits as mien regress
# does: 0 all is as approved, 1 something differs, 2 no comparison was possible.
set -uo pipefail

# A folder of the job, apart from the user's files.
out=${RUNNER_TEMP:?}/mien-regression
rm -rf "$out"  # of another study in the same job
# shellcheck disable=SC2086 # a word an argument
mien regress "$MANIFEST" --out "$out" ${ARGUMENTS:-}
code=$?
for summary in "$out"/*-regression/summary.md; do
  [[ ! -e $summary ]] || cat "$summary" >>"${GITHUB_STEP_SUMMARY:-/dev/stdout}"
done
exit $code
