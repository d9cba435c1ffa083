#!/bin/sh
# Everything on a fresh machine: ./go run DECK [options], ./go test, ./go build.
# Installs what packages.txt names and is missing, configures, builds, runs.
set -eu
here=$(cd "$(dirname "$0")" && pwd)

usage() {
  cat <<TEXT
./go run decks/subsidence/subsidence.deck

  ./go run DECK [options]   build if needed, then blocks run DECK (results beside you)
  ./go test                 build with warnings as errors and run every test
  ./go build                build only: build/release/src/blocks
  ./go install [PREFIX]     program, man pages and library for find_package(blocks) to
                            PREFIX (/usr/local)
  ./go package              Debian packages in build/release/packages
  ./go validate [N]         N random layers (100000) made and judged, the certificate
                            against brute force, the same bits from g++ and clang++,
                            and all problems with known answers; each, whatever the
                            others say: the exit code is that of the first at fault
  ./go validate predicates [N]
                            the contact predicates on N inputs (10000000) against MPFR
  ./go validate reliability
                            what is promised of files and inputs, tested at length:
                            kills, full disks, failing memory, forged and mutated files
  ./go validate bits        ten decks: the same bits from g++ and clang++ at -O0, -O2, -O3,
                            1 to 8 threads, every instruction set (--quick: two builds,
                            a quarter of the steps, one and two threads)
  ./go validate fuzz [TARGET[=N]...]
                            libFuzzer on every reader, 10,335,000 executions
  ./go validate soak [N]    the 850 blocks of subsidence for N steps (10000000)
  ./go validate rest [N]    a wall of 1,000 bricks at rest for N steps (1000000)
  ./go validate problems [NAME...]
                            problems with known answers: decks, checks, figures, one report,
                            validation/REPORT.md and .html; --kept: whose rows it has
  ./go study [N]            N frames (1000) of every scene of contact detection by the
                            rules of every run: no hang-up, no fall-through where these
                            rules are known to pass; every decision exact
  ./go bench [PART...]      times of scenes in several states, against other codes (6 minutes;
                            --quick: one): wall, pile, slope, crater, subsidence, decks,
                            search, predicates, generation; writes bench.md, .json, .png
                            beside you
  ./go asan                 every test under the address and undefined sanitizers
  ./go tsan                 every test under the thread sanitizer
  ./go fuzz NAME [SECONDS]  libFuzzer on a reader (60): deck, run, mesh, geojson, wkt,
                            layer, results, checkpoint; found inputs in build/found/NAME
  ./go blocks ARGUMENTS     any other command of the program (plot, check, cards ...)
TEXT
}

install_packages() {  # [more than packages.txt names]
  missing=""
  for package in $(cat "$here/packages.txt") "$@"; do
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
  # shellcheck disable=SC2086  # lists of words
  if ! { $root apt-get update -qq &&
    $root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $missing; } >"$log" 2>&1; then
    tail -n 20 "$log" >&2
    echo "the installation failed; the whole log: $log" >&2
    exit 1
  fi
}

build() {  # preset [target...]
  preset=$1; shift
  install_packages
  log="$here/build/$preset.log"
  mkdir -p "$here/build"
  # the first time it takes long: say where one can see it at work
  if [ ! -e "$here/build/$preset/.ninja_log" ]; then
    echo "building for the first time, some minutes (tail -f $log) ..." >&2
  elif [ "$command" != run ] && [ "$command" != blocks ]; then
    echo "building ..." >&2
  fi
  if ! { (cd "$here" && cmake --preset "$preset" && cmake --build --preset "$preset" ${1:+--target "$@"}) >"$log" 2>&1; }; then
    tail -n 60 "$log" >&2
    echo "the build failed; the whole log: $log" >&2
    exit 1
  fi
}

number() {  # the text if it is a whole number, else 0: the program tells what is wrong
  case $1 in *[!0-9]* | "") echo 0 ;; *) echo "$1" ;; esac
}

command=${1:-help}
[ $# -gt 0 ] && shift
case $command in
  run|blocks)
    build release blocks
    if [ "$command" = run ]; then set -- run "$@"; fi
    exec "$here/build/release/src/blocks" "$@" ;;
  build) build release blocks ;;
  install)
    build release blocks blocks_library manual package_logs
    cmake --install "$here/build/release" --prefix "${1:-/usr/local}" ;;
  test) build ci; cd "$here" && exec ctest --preset ci "$@" ;;
  package)
    install_packages dpkg-dev file
    build release blocks blocks_library manual package_logs
    (cd "$here/build/release" && cpack >"$here/build/package.log" 2>&1) \
      || { cat "$here/build/package.log" >&2; exit 1; }
    ls -l "$here"/build/release/packages/*.deb ;;
  validate)
    programs="$here/build/release/validation/robustness"
    problems() { /usr/bin/python3 "$here/validation/problems/problems.py" \
      "$here/build/release/src/blocks" --report "$@"; }
    if [ "${1:-}" = problems ]; then
      build release blocks
      shift
      problems "$@"; exit
    fi
    if [ "${1:-}" = predicates ]; then
      build release predicates
      # fewer inputs leave the report as it is
      [ "$(number "${2:-10000000}")" -ge 10000000 ] || exec "$programs/predicates" --inputs "$2"
      exec "$programs/predicates" --inputs "${2:-10000000}" --report "$here/validation/robustness/PREDICATES"
    fi
    if [ "${1:-}" = rest ]; then
      build release rest
      # fewer steps leave the report as it is
      [ "$(number "${2:-1000000}")" -ge 1000000 ] || exec "$here/build/release/validation/rest/rest" --steps "$2"
      exec "$here/build/release/validation/rest/rest" --steps "${2:-1000000}" --report "$here/validation/rest/REST"
    fi
    if [ "${1:-}" = reliability ]; then
      build release
      BLOCKS_THOROUGH=1 exec /usr/bin/python3 "$here/validation/reliability/report.py" \
        "$here/build/release" "$here/validation/reliability/REPORT"
    fi
    if [ "${1:-}" = fuzz ]; then
      build fuzz fuzz_seeds fuzz_mesh fuzz_deck fuzz_wkt fuzz_geojson fuzz_layer fuzz_run \
        fuzz_checkpoint fuzz_results
      shift
      exec /usr/bin/python3 "$here/validation/reliability/fuzz.py" "$here/build/fuzz" \
        "$here/validation/reliability/FUZZ" "$@"
    fi
    if [ "${1:-}" = bits ]; then
      same_bits() { exec /usr/bin/python3 "$here/validation/reliability/same_bits.py" \
        "$here/build/bits" "$@"; }
      [ "${2:-}" = --quick ] || same_bits "$here/validation/reliability/SAME_BITS"
      build ci blocks
      same_bits "$here/build/bits/QUICK" --quick --program "g++ -O3=$here/build/ci/src/blocks"
    fi
    if [ "${1:-}" = soak ]; then
      build release soak
      soak() { "$here/build/release/validation/reliability/soak" --steps "$@"; }
      # fewer steps leave the report as it is
      [ "$(number "${2:-10000000}")" -ge 10000000 ] || { soak "$2"; exit; }
      soak "${2:-10000000}" --report "$here/validation/reliability/SOAK"
      /usr/bin/python3 "$here/validation/reliability/version.py" >>"$here/validation/reliability/SOAK.md"
      exit
    fi
    layers=${1:-100000}
    [ "$(number "$layers")" -gt 0 ] || {
      echo "go: error: validate has no part '$layers': predicates, reliability, bits, fuzz, soak," \
           "rest, problems, or a number of layers" >&2
      exit 2
    }
    build release blocks robustness certificate_study distribution_study predicates
    code=0
    part() { "$@" || { at=$?; echo "go: $1: exit code $at" >&2; [ $code != 0 ] || code=$at; }; }
    part problems
    part "$programs/robustness" --layers "$layers" --report "$here/validation/robustness/REPORT"
    part "$programs/certificate_study" --report "$here/validation/robustness/CERTIFICATE"
    part "$programs/distribution_study" --report "$here/validation/robustness/DISTRIBUTION"
    part "$programs/predicates" --report "$here/validation/robustness/PREDICATES"
    part "$here/validation/robustness/compilers.sh" "$here/build/compilers"
    exit $code ;;
  study)
    build release blocks
    frames=${1:-1000}
    # fewer frames leave the table as it is
    table=; [ "$(number "$frames")" -lt 1000 ] || table="--csv $here/validation/robustness/CONTACTS.csv"
    exec "$here/build/release/src/blocks" study contacts all --variants default \
      --frames "$frames" -j "$(nproc)" --gate $table ;;
  bench)
    build release bench
    exec "$here/build/release/validation/performance/bench" "$@" ;;
  asan|tsan)
    preset=$command
    [ "$command" = tsan ] || preset=fuzz  # one build for both
    build "$preset"
    exec /usr/bin/python3 "$here/validation/reliability/sanitizers.py" "$command" \
      "$here/build/$preset" "$here/validation/reliability/SANITIZERS" "$@" ;;
  fuzz)
    case ${1:-} in
      deck|run) set -- "$1" "${2:-60}" bad fuzz/run; dictionary=-dict=$here/tests/fuzz/deck.dict ;;
      geojson|wkt) set -- "$1" "${2:-60}" bad_exchange ;;
      mesh|layer) set -- "$1" "${2:-60}" "fuzz/$1" ;;
      results|checkpoint) set -- "$1" "${2:-60}" ;;
      *) echo "go: error: fuzz needs a name: deck, run, mesh, geojson, wkt, layer, results," \
           "checkpoint" >&2; exit 2 ;;
    esac
    build fuzz "fuzz_$1" fuzz_seeds
    found=$here/build/found; name=$1; seconds=$2
    shift 2
    mkdir -p "$found/$name" "$found/crash" "$found/seeds/$name"
    "$here/build/fuzz/tests/fuzz/fuzz_seeds" "$found/seeds"
    cd "$here/tests/corpus"
    exec "$here/build/fuzz/tests/fuzz/fuzz_$name" -max_total_time="$seconds" -timeout=60 \
      -rss_limit_mb=4096 -print_final_stats=1 -artifact_prefix="$found/crash/" \
      ${dictionary:+"$dictionary"} "$found/$name" "$found/seeds/$name" "$@" ;;
  help|-h|--help) usage ;;
  *) echo "go: no command '$command'" >&2; usage >&2; exit 2 ;;
esac
