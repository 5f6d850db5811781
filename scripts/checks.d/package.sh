#!/usr/bin/env bash
# Makes the package for Debian from build/trembler, unpacks it into a folder, and uses the program from there, where the
# source tree cannot be reached. As root in continuous integration it is also installed and removed by dpkg. With lintian,
# if that is installed, the package is also checked against Debian's policy.
set -euo pipefail
if [[ ! -x build/trembler ]]; then
    echo "build/trembler has not been built"
    exit 77
fi
for tool in cpack dpkg-deb dpkg-shlibdeps dpkg-parsechangelog file; do
    if ! command -v "$tool" >/dev/null; then
        echo "The package needs $tool: scripts/install"
        exit 77
    fi
done

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() {
    echo "$*"
    exit 1
}

# gzip packs in a tenth of the time of xz, which the released package uses.
cpack --config build/CPackConfig.cmake -G DEB -B "$work" -D CPACK_DEBIAN_COMPRESSION_TYPE=gzip >"$work/log" 2>&1 ||
    fail "$(cat "$work/log")"
deb=$(find "$work" -maxdepth 1 -name '*.deb')
tree=$work/unpacked
dpkg-deb -x "$deb" "$tree"

# --- what the package says -----------------------------------------------------------------------------------------------

field() { dpkg-deb --field "$deb" "$1"; }
[[ $(field Section) == games ]] || fail "the section is not games"
[[ $(field Version) == "$(dpkg-parsechangelog -l packaging/changelog -S Version)" ]] ||
    fail "packaging/changelog does not begin with version $(field Version)"
depends=$(field Depends)
for package in libbox2d libsdl2 libopenal libgl1 libegl1 fonts-inter; do
    [[ $depends == *"$package"* ]] || fail "does not depend on $package: $depends"
done
for name in bin/trembler share/applications/trembler.desktop share/icons/hicolor/scalable/apps/trembler.svg \
    share/man/man1/trembler.1.gz share/doc/trembler/copyright share/doc/trembler/changelog.Debian.gz \
    share/trembler/mods/humid-air/mod.json; do
    [[ -s $tree/usr/$name ]] || fail "/usr/$name is missing"
done
odd=$(find "$tree" ! -type l \( ! -perm -444 -o -perm /022 -o -type f -perm /111 ! -path '*/usr/bin/trembler' \))
[[ -z $odd ]] || fail "wrong permissions: $odd"
for folder in assets levels mods; do
    diff -r "$folder" "$tree/usr/share/trembler/$folder" || fail "$folder is not what is installed"
done
if command -v lintian >/dev/null; then
    lintian --allow-root --fail-on error,warning "$deb" # packaging/lintian-overrides lists the intended exceptions
fi

# --- what the program does -----------------------------------------------------------------------------------------------

export HOME=$work/home SDL_VIDEODRIVER=offscreen SDL_AUDIODRIVER=dummy LIBGL_ALWAYS_SOFTWARE=1 LP_NUM_THREADS=0
mkdir "$HOME"
unset DISPLAY WAYLAND_DISPLAY TREMBLER_HOME XDG_DATA_HOME
# Hides the source tree where that is allowed; elsewhere a level that only the unpacked tree contains must be enough.
hidden=(env "source=$PWD")
# shellcheck disable=SC2016 # expanded by the inner shell
if unshare --user --map-root-user --mount true 2>/dev/null; then
    hidden+=(unshare --user --map-root-user --mount bash -c 'mount -t tmpfs none "$source" && cd / && exec "$@"' hidden)
else
    hidden+=(bash -c 'cd / && exec "$@"' plain)
fi
use() { # PROGRAM ARGUMENTS...: shows its output only if it fails
    "${hidden[@]}" "$@" >"$work/output" 2>&1 || fail "$* ended with status $?: $(tail -n 20 "$work/output")"
}
try_out() { # PROGRAM, of the unpacked or installed tree
    use "$1" --version
    grep -q "${2}" "$work/output" || fail "the version is $(cat "$work/output")"
    use "$1" mod list
    grep -q humid-air "$work/output" || fail "the mods are not found: $(cat "$work/output")"
    use "$1" screenshot "$work/own.json" --frame 2 --size 320x180 --out "$work/picture.png"
    file "$work/picture.png" | grep -q 'PNG image data, 320 x 180' || fail "no picture was drawn"
}
version=$(field Version)
version=${version%-*}
cp levels/first/1-first-contact.json "$work/own.json" # its parts are found in the tree, not beside it
mkdir "$tree/usr/share/trembler/levels/only-here"
cp "$work/own.json" "$tree/usr/share/trembler/levels/only-here/1-of-the-package.json"
try_out "$tree/usr/bin/trembler" "$version"
find "$tree/usr/share/trembler/levels" -mindepth 1 -type d ! -name only-here -exec rm -r {} + # verifying them takes longer
use "$tree/usr/bin/trembler" verify
grep -q '^levels/only-here/1-of-the-package.json: valid$' "$work/output" ||
    fail "the levels are not those of the package: $(cat "$work/output")"

# --- installed -----------------------------------------------------------------------------------------------------------

if [[ ${CI-} ]] && ((EUID == 0)) && ! dpkg-query --status trembler >/dev/null 2>&1; then
    dpkg --install "$deb" >"$work/dpkg" 2>&1 || fail "$(cat "$work/dpkg")"
    trap 'dpkg --remove trembler >/dev/null 2>&1; rm -rf "$work"' EXIT
    cmp "$(command -v trembler)" "$work/unpacked/usr/bin/trembler" || fail "what is installed is not in the path"
    try_out trembler "$version"
    use trembler verify /usr/share/trembler/levels/first
    dpkg --remove trembler >"$work/dpkg" 2>&1 || fail "$(cat "$work/dpkg")"
    left=$(find /usr/share/trembler /usr/share/doc/trembler /usr/bin/trembler 2>/dev/null || true)
    [[ -z $left ]] || fail "dpkg --remove leaves $left"
fi
