#!/bin/sh
# The packages on a clean Debian 12: packaging/try_on_debian.sh FOLDER, as root, behind
# ./go package. Makes a minimal system in FOLDER (debootstrap), installs blocks there by
# apt, runs a deck, draws it and reads it; then libblocks-dev, and builds the examples; then
# python3-blocks.
set -eu
here=$(cd "$(dirname "$0")/.." && pwd)
system=${1:?FOLDER}
[ -e "$system/etc/debian_version" ] || debootstrap --variant=minbase bookworm "$system"
rm -rf "$system/packages"
mkdir "$system/packages"
cp "$here"/build/release/packages/*.deb "$system/packages"

inside() { chroot "$system" env -i PATH=/usr/bin:/usr/sbin:/bin:/sbin LC_ALL=C.UTF-8 \
  DEBIAN_FRONTEND=noninteractive sh -euc "$1"; }
size() { du -smx "$system" | cut -f1; }

inside 'apt-get update -qq'
before=$(size)
inside 'apt-get install -y -qq --no-install-recommends /packages/blocks_*.deb >/packages/log 2>&1 ||
  { cat /packages/log; exit 1; }'
echo "blocks and what it needs: $(($(size) - before)) MB more"
inside 'mkdir -p /try && cd /try && blocks --version
  blocks run /usr/share/doc/blocks/decks/stack/stack.deck
  blocks plot stack.vtkhdf --forces -o stack.png
  blocks history stack.vtkhdf -q y:4,speed:max
  test -s stack.png
  test -s /usr/share/man/man1/blocks.1.gz && test -s /usr/share/man/man5/blocks-deck.5.gz
  bash -c "source /usr/share/bash-completion/completions/blocks && complete -p blocks"'

inside 'apt-get install -y -qq --no-install-recommends g++ cmake ninja-build \
    /packages/libblocks-dev_*.deb >/packages/log 2>&1 || { cat /packages/log; exit 1; }
  rm -rf /try/consumer && cp -r /usr/share/doc/libblocks-dev/examples/consumer /try
  cd /try/consumer
  cmake -G Ninja -B build -DCMAKE_BUILD_TYPE=Release >/packages/log 2>&1 &&
    cmake --build build >>/packages/log 2>&1 || { cat /packages/log; exit 1; }
  build/layer | tail -n 1; build/servo | tail -n 2
  apt-get -o Dpkg::Use-Pty=0 purge -y -qq blocks >/dev/null && ! command -v blocks'
inside 'apt-get install -y -qq --no-install-recommends python3-matplotlib /packages/blocks_*.deb \
    /packages/python3-blocks_*.deb >/packages/log 2>&1 || { cat /packages/log; exit 1; }
  cd /try && python3 -c "
import blocks
run = blocks.run(\"/usr/share/doc/blocks/decks/stack/stack.deck\", \"python\")
run.results[-1].plot(forces=True).figure.savefig(\"python.png\")
print(run)"'
echo "all packages are sound"
