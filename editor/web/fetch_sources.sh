#!/bin/sh
# usage: fetch_sources.sh FOLDER
# Puts the unpacked source packages of what the page of the editor needs into FOLDER, unless they
# are there. Uses apt with lists of its own there: needs neither root nor a deb-src line.
set -eu
packages="imgui libpng1.6 libzstd tinyxml2 zlib"
[ -e "$1/complete" ] && exit 0
mkdir -p "$1/apt/lists/partial"
cd "$1"
. /etc/os-release
key=/usr/share/keyrings/debian-archive-keyring.gpg
echo "deb-src [signed-by=$key] http://deb.debian.org/debian $VERSION_CODENAME main" > apt/sources.list
own="-o Dir::Etc::sourcelist=$PWD/apt/sources.list -o Dir::Etc::sourceparts=- -o Dir::State::lists=$PWD/apt/lists"
own="$own -o Dir::Cache=$PWD/apt"
apt-get $own -q update
apt-get $own -q source --download-only $packages
for package in *.dsc; do dpkg-source --no-check -x "$package"; done
touch complete
