#!/bin/bash
# Installs the package PACKAGE, or else that of RELEASE (v0.3.0) from REPOSITORY (owner/name), on Debian 12 or 13.
set -euo pipefail

# shellcheck source=/dev/null
. /etc/os-release
if [[ ${ID:-} != debian || ! ${VERSION_ID:-} =~ ^(12|13)$ ]]; then
  echo "::error::mien regress needs Debian 12 or 13; add to the job: container: debian:12"
  exit 1
fi
if [[ -z ${PACKAGE:-} && ! ${RELEASE:-} =~ ^v[0-9]+\.[0-9]+\.[0-9]+$ ]]; then
  echo "::error::use the action of a release, for example @v0.3.0, instead of @${RELEASE:-}"
  exit 1
fi
apt-get update -q
if [[ -z ${PACKAGE:-} ]]; then
  apt-get install -y -q --no-install-recommends ca-certificates curl
  PACKAGE=$(mktemp -d)/mien.deb
  curl --fail --silent --show-error --location --retry 3 --output "$PACKAGE" \
    "https://github.com/$REPOSITORY/releases/download/$RELEASE/mien-debian$VERSION_ID.deb"
fi
DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends "$(realpath "$PACKAGE")"
mien version
