#!/usr/bin/env bash
# The Debian packages: two builds in folders of other names are the same bytes, lintian finds no error, and in a fresh
# Debian they install, run and leave nothing behind. On demand: as root, with debootstrap, lintian and the network; minutes.
# usage: packages.sh [FOLDER that keeps the builds and the fresh Debian for the next time]
set -euo pipefail
cd "$(dirname "$0")/../.."
folder=${1:-$(mktemp -d)}
fail() { echo "packages: $*" >&2; exit 1; }
for program in debootstrap lintian; do command -v "$program" >/dev/null || fail "apt-get install $program"; done

echo "1/4  two builds"
tools/package "$folder/one" >/dev/null
tools/package "$folder/the-other" >/dev/null
for package in "$folder"/one/*.deb; do
    cmp "$package" "$folder/the-other/$(basename "$package")" || fail "$(basename "$package") differs"
done

echo "2/4  lintian"
lintian --allow-root --fail-on error --suppress-tags initial-upload-closes-no-bugs "$folder"/one/*.deb

echo "3/4  a fresh Debian"
. /etc/os-release
if [ ! -e "$folder/debian.tar" ]; then
    debootstrap --variant=minbase "$VERSION_CODENAME" "$folder/debian" "${MIRROR:-http://deb.debian.org/debian}" >"$folder/debootstrap.log" ||
        fail "$(tail "$folder/debootstrap.log")"
    tar -C "$folder/debian" -cf "$folder/debian.tar" .
fi
root=$folder/root
rm -rf "$root"
mkdir "$root"
tar -C "$root" -xf "$folder/debian.tar"
cp /etc/resolv.conf "$root/etc/"
cp -r /etc/apt/apt.conf.d/. "$root/etc/apt/apt.conf.d/"  # proxies
cp "$folder"/one/*.deb "$root/tmp/"
inside() { chroot "$root" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive bash -ec "$1"; }
traces() { (cd "$root" && find . -name '*tanktread*' -not -path './tmp/*' -not -path './var/log/*' | sort); }
inside 'apt-get update -qq; apt-get install -y -qq --no-install-recommends /tmp/*.deb' >"$folder/install.log" 2>&1 || fail "$(tail "$folder/install.log")"

echo "4/4  what is installed runs, and is removed"
inside '
cd /tmp
tanktread selftest
tanktread run /usr/share/tanktread/cases/04-cell-relaxing/case.toml --progress none --set time.end="1 ms" --set numerics.dx="1 um" -o run
tanktread report run
python3 -c "import tanktread; print(len(tanktread.Results(\"run\").frames()), \"frames read\")"
apt-get purge -y -qq tanktread libtanktread-dev python3-tanktread' >"$folder/use.log" 2>&1 || fail "$(tail "$folder/use.log")"
tail -n 20 "$folder/use.log"
! grep -i "not empty\|warning" "$folder/use.log" || fail "told as it was removed"
[ -z "$(traces)" ] || fail "left behind: $(traces)"
echo "packages: the same bytes twice, no error of lintian, installed, run and removed"
