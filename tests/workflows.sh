#!/usr/bin/env bash
# Checks the files in .github/workflows. Needs node and npm.
#   tests/workflows.sh
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
npm ci --silent --no-audit --no-fund --prefix tests/Workflows
npm test --silent --prefix tests/Workflows
