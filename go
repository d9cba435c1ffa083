#!/bin/sh
# Works on a fresh machine: installs the packages that are missing, configures, builds and
# runs. A run needs those of packages.txt, the Python package also those of
# packages-python.txt, tests and validation also those of packages-test.txt. ./go help
# lists the commands.
set -eu
here=$(cd "$(dirname "$0")" && pwd)

usage() {
  cat <<TEXT
./go COMMAND installs the packages that are missing, builds what the command needs, and runs it.

  run DECK [OPTIONS]   run a deck; the results are written to the current folder
  blocks ARGUMENTS     any other command of the program: plot, history, check, cards ...
  build [PRESET [TARGET...]]
                       build only; without arguments build/release/src/blocks
  test [OPTIONS]       build with warnings as errors and run every test (ctest options)
  python [ARGUMENTS]   an interpreter that has the Python package blocks
  install [PREFIX]     program, man pages, library and Python package to PREFIX (/usr/local)
  package              program archive and Debian packages in build/release/packages
  bench [PART...]      short for ./go validate bench
  validate SUBCOMMAND  long checks and measurements; each subcommand has its own --help:
                       problems     problems with known answers, validation/REPORT.md
                       layers       generated layers and their certificate
                       cells        cells of random joints against exact answers
                       traces       joint sets fitted to the maps that they made
                       law-figures  the laws of joints as curves
                       cuts         random networks of joints, cut and judged
                       splits       random blocks, each cut in two and judged
                       seeds        random layers of many seeds
                       predicates   the contact predicates against MPFR
                       study        the scenes of contact detection
                       frames       decks in other frames
                       steps        the error of the integration for three time steps
                       reliability  damaged files, full disks, failing memory, kills
                       bits         the same bits from every compiler and thread count
                       fuzz         libFuzzer on every reader
                       cracks       thousands of cracks, audited
                       soak, rest   many steps of one deck
                       bench        times of scenes, against other codes
                       python       times of steps from Python
                       big          one model of up to a million blocks
                       asan, tsan   every test under the sanitizers
TEXT
}

needed_for() {  # preset
  cat "$here/packages.txt"
  [ "$1" = release ] || cat "$here/packages-test.txt"
}

install_packages() {  # package...
  missing=""
  for package in "$@"; do
    dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q "ok installed" || missing="$missing $package"
  done
  [ -z "$missing" ] && return
  echo "installing:$missing" >&2
  root=""
  if [ "$(id -u)" != 0 ]; then
    root=sudo
    command -v sudo >/dev/null || {
      echo "go: error: neither root nor sudo; as root: apt-get install --no-install-recommends$missing" >&2
      exit 1
    }
  fi
  log="$here/build/packages.log"
  mkdir -p "$here/build"
  # shellcheck disable=SC2086  # $root and $missing are lists of words.
  if ! { $root apt-get update -qq &&
    $root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $missing; } >"$log" 2>&1; then
    tail -n 20 "$log" >&2
    echo "go: error: the installation failed, see $log" >&2
    exit 1
  fi
}

# The builds of a clone that was copied or moved are of no use: CMake refuses them.
forget_builds_of_other_clones() {
  for cache in "$here"/build/*/CMakeCache.txt; do
    [ -e "$cache" ] || continue
    made_in=$(sed -n 's/^CMAKE_HOME_DIRECTORY:INTERNAL=//p' "$cache")
    case $made_in in "$here"/*) continue ;; esac  # a project within this clone
    [ "$made_in" -ef "$here" ] && continue
    echo "go: $(dirname "$cache") was made in $made_in; building it again" >&2
    rm -rf "$(dirname "$cache")"
  done
}

build() {  # preset [target...]
  preset=$1; shift
  # shellcheck disable=SC2046  # The output is a list of words.
  install_packages $(needed_for "$preset")
  log="$here/build/$preset.log"
  mkdir -p "$here/build"
  # The first build takes minutes, so its message names the log to follow.
  if [ ! -e "$here/build/$preset/.ninja_log" ]; then
    echo "building for the first time takes minutes (tail -f $log) ..." >&2
  elif [ "$command" != run ] && [ "$command" != blocks ] && [ "$command" != python ]; then
    echo "building ..." >&2
  fi
  if ! { (cd "$here" && cmake --preset "$preset" && cmake --build --preset "$preset" ${1:+--target "$@"}) >"$log" 2>&1; }; then
    tail -n 60 "$log" >&2
    echo "go: error: the build failed, see $log" >&2
    exit 1
  fi
}

build_python() {  # target...
  # shellcheck disable=SC2046
  install_packages $(cat "$here/packages-python.txt")
  build release "$@"
}

command=${1:-help}
[ $# -gt 0 ] && shift
forget_builds_of_other_clones
case $command in
  run|blocks)
    build release blocks
    if [ "$command" = run ]; then set -- run "$@"; fi
    exec "$here/build/release/src/blocks" "$@" ;;
  build)
    [ $# -gt 0 ] || set -- release blocks
    build "$@" ;;
  python)
    build_python blocks blocks_python
    PYTHONPATH="$here/build/release/python${PYTHONPATH:+:$PYTHONPATH}" exec /usr/bin/python3 "$@" ;;
  install)
    build_python blocks blocks_library blocks_python manual package_logs
    cmake --install "$here/build/release" --prefix "${1:-/usr/local}" ;;
  test) build ci; cd "$here" && exec ctest --preset ci "$@" ;;
  package)
    install_packages dpkg-dev file
    build_python blocks blocks_library blocks_python manual package_logs archive
    (cd "$here/build/release" && cpack >"$here/build/package.log" 2>&1) \
      || { cat "$here/build/package.log" >&2; exit 1; }
    ls -l "$here/build/release/packages" ;;
  validate)
    # shellcheck disable=SC2046
    install_packages $(needed_for ci)
    exec /usr/bin/python3 "$here/validation/validate.py" "$@" ;;
  bench) exec "$here/go" validate bench "$@" ;;
  help|-h|--help) usage ;;
  *) echo "go: error: no command '$command'" >&2; usage >&2; exit 2 ;;
esac
