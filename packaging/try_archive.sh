#!/bin/sh
# The program archive on bare systems: packaging/try_archive.sh FOLDER, as root, after
# ./go package. Makes minimal Debian 12 and 13 in FOLDER (debootstrap) and unpacks the
# archive there; nothing is installed. The run and the figures must be the same as those of
# build/release/src/blocks.
set -eu
here=$(cd "$(dirname "$0")/.." && pwd)
mkdir -p "${1:?FOLDER}"
folder=$(cd "$1" && pwd)

commands='$blocks --version
  $blocks check $decks/stack/stack.deck
  $blocks run $decks/stack/stack.deck >run.log
  $blocks plot stack.vtkhdf --forces -o stack.png
  $blocks plot stack.vtkhdf --forces -o stack.svg
  $blocks plot stack.vtkhdf --forces -o stack.pdf
  $blocks history stack.vtkhdf -q y:4,speed:max -o history.png
  $blocks view stack.vtkhdf'

rm -rf "$folder/expected"
mkdir "$folder/expected"
(cd "$folder/expected" && blocks=$here/build/release/src/blocks decks=$here/decks sh -euc "$commands") >/dev/null

for release in bookworm trixie; do
  system=$folder/$release
  [ -e "$system/etc/debian_version" ] || debootstrap --variant=minbase "$release" "$system"
  rm -rf "$system/try"
  mkdir -p "$system/try/results"
  cp "$here"/build/release/packages/blocks-*.tar.gz "$system/try"
  echo "Debian $(cat "$system/etc/debian_version"):"
  chroot "$system" env -i PATH=/usr/bin:/bin HOME=/try sh -euc "
    test ! -e /usr/share/fonts
    tar -xf /try/blocks-*.tar.gz -C /try
    cd /try/results
    blocks=\$(echo /try/blocks-*/bin/blocks) decks=\$(echo /try/blocks-*/decks)
    $commands"
  for name in stack.png stack.svg history.png; do
    cmp "$folder/expected/$name" "$system/try/results/$name"
  done
  for results in "$folder/expected" "$system/try/results"; do
    grep '"state_hash"' "$results/stack.summary.json"
  done | uniq | tee "$folder/hashes"
  [ "$(wc -l <"$folder/hashes")" = 1 ]
  [ -s "$system/try/results/stack.pdf" ] && [ -s "$system/try/results/stack.html" ]
done
echo "the archive is sound"
