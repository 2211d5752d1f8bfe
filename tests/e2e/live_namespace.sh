# shellcheck shell=bash disable=SC2154 # the caller sets `arguments`
# To be sourced: runs the calling script again inside a network namespace of its own, from which no other
# machine can be reached. Exit code 77 (skipped) where that is not possible.

skip() {
  echo "SKIPPED: $*"
  exit 77
}

fail() {
  echo "FAILED: $*"
  exit 1
}

for tool in unshare ip "$@"; do
  command -v "$tool" > /dev/null || skip "$tool is not installed"
done

if [ -z "${SCREE_IN_NAMESPACE:-}" ]; then
  if [ "$(id -u)" = 0 ]; then enter=(unshare -n); else enter=(unshare -rn); fi
  "${enter[@]}" ip link set lo up 2> /dev/null || skip "network namespaces are not allowed here"
  SCREE_IN_NAMESPACE=1 exec "${enter[@]}" bash "$0" "${arguments[@]}"
fi
ip link set lo up || skip "the loopback interface cannot be used"
