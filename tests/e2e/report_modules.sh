# shellcheck shell=bash
# The packages of io/viewer/package-lock.json, in a folder of the build. To be sourced.
#
#   viewer_modules SOURCE BUILD    sets `modules` to a node_modules folder; ends with 77 (skipped) where Node, npm or
#                                  the network is missing
viewer_modules() {
  local source=$1 folder=$2/viewer-modules log
  command -v node >/dev/null && command -v npm >/dev/null || { echo "skipped: no Node here"; exit 77; }
  mkdir -p "$folder"
  modules=$folder/node_modules
  exec 9>"$folder/lock"
  flock 9  # two tests may come at once
  if [ -e "$folder/ready" ] && cmp -s "$source/io/viewer/package-lock.json" "$folder/package-lock.json"; then
    exec 9>&-
    return
  fi
  rm -f "$folder/ready"
  cp "$source/io/viewer/package.json" "$source/io/viewer/package-lock.json" "$folder"
  log=$folder/npm.log
  if ! (cd "$folder" && npm ci --ignore-scripts --no-audit --no-fund --fetch-retries 1 >"$log" 2>&1); then
    if grep -qE 'ENOTFOUND|EAI_AGAIN|ECONNREFUSED|ECONNRESET|ETIMEDOUT|ENETUNREACH|EHOSTUNREACH|ERR_SOCKET_TIMEOUT|EPROTO|CERT|code E[45][0-9][0-9]' "$log"; then
      echo "skipped: the packages of io/viewer cannot be fetched here"
      exit 77
    fi
    tail -n 20 "$log" >&2
    exit 1
  fi
  touch "$folder/ready"
  exec 9>&-
}
