# shellcheck shell=bash
# Installs what packages.txt lists. To be sourced; the caller has set `root` to the top of the project.
#
#   packages_install SECTION...    0: all installed; 2: needs missing rights, prints the command; else apt's code

# Packages of the given sections, one per line, without those whose command is already installed from another source.
packages_list() {
  local package command
  packages_entries "$@" | while read -r package command; do
    [ -n "$command" ] && command -v "$command" >/dev/null || echo "$package"
  done
}

# Lines of the given sections: package, or package and command.
packages_entries() {
  awk -v wanted=" $* " '
    /^# \[/ { section = $2; gsub(/[][]/, "", section) }
    /^[^#]/ && index(wanted, " " section " ") { print $1, $2; any = 1 }
    END { if (!any) { print "packages.txt has no section" wanted > "/dev/stderr"; exit 1 } }' "${root:?}/packages.txt"
}

# Those among the given packages that are not installed.
packages_missing() {
  comm -23 <(printf '%s\n' "$@" | sort -u) \
    <(dpkg-query -W -f='${db:Status-Status} ${Package}\n' "$@" 2>/dev/null | sed -n 's/^installed //p' | sort -u)
}

packages_install() {
  local list missing log as_root=() code=0 start=$SECONDS
  packages_entries "$@" >/dev/null || return
  list=$(packages_list "$@")
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    echo "Not a Debian system, so nothing is installed; packages.txt names what is needed."
    return 0
  fi
  mapfile -t list <<<"$list"
  mapfile -t missing < <(packages_missing "${list[@]}")
  if [ ${#missing[@]} = 0 ]; then
    echo "All packages are there."
    return 0
  fi
  if [ "$(id -u)" != 0 ]; then
    if ! sudo -n true 2>/dev/null; then
      echo "Some packages are missing, and to install them takes root. Type this, then start again:" >&2
      echo "  sudo apt-get update && sudo apt-get install -y --no-install-recommends ${missing[*]}" >&2
      return 2
    fi
    as_root=(sudo -n)
  fi
  echo "Installing ${#missing[@]} packages and what they depend on: ${missing[*]}"
  log=$(mktemp "${TMPDIR:-/tmp}/scree-packages.XXXXXX")
  {
    "${as_root[@]}" apt-get -q -o Acquire::Languages=none update &&
      "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -y --no-install-recommends \
        -o DPkg::Lock::Timeout=300 -o Dpkg::Use-Pty=0 install "${missing[@]}"
  } </dev/null >"$log" 2>&1 || code=$?
  if [ $code != 0 ]; then
    tail -n 25 "$log" >&2
    echo "apt-get failed with code $code; all it said is in $log" >&2
    return $code
  fi
  rm -f "$log"
  echo "Installed in $((SECONDS - start)) s."
}
