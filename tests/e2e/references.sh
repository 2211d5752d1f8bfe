#!/bin/bash
# The reference programs of the case library check themselves and print the tables that are stored beside them.
set -euo pipefail
for table in "$1"/cases/*/reference/*.csv; do
  name=$(basename "$table" .csv)
  /usr/bin/python3 "$(dirname "$table")/${name//-/_}.py" | cmp - "$table"
done
