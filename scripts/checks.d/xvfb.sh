#!/usr/bin/env bash
# Plays in a window on a screen, as players do, where other tests draw into a picture: with the mouse, with the keyboard,
# with a gamepad, and while the window changes its size. The screen is a virtual one of Xvfb.
set -euo pipefail
program=build/tests/test_game_ui # the newer one: ./check builds that of the stage asan, ./check --fast the other
if [[ build-asan/tests/test_game_ui -nt $program ]]; then
    program=build-asan/tests/test_game_ui
fi
if [[ ! -x $program ]]; then
    echo "build/tests/test_game_ui has not been built, nor that of the stage asan"
    exit 77
fi
if ! command -v Xvfb >/dev/null; then
    echo "Tests in a window on a screen need Xvfb: scripts/install"
    exit 77
fi
work=$(mktemp -d)
# Xvfb chooses a free display number, and prints it once the display can be used.
Xvfb -displayfd 3 -screen 0 3840x2400x24 -nolisten tcp -noreset 3>"$work/display" >"$work/log" 2>&1 &
server=$!
trap 'kill "$server" 2>/dev/null || true; rm -rf "$work"' EXIT
for ((tenths = 0; tenths < 300; ++tenths)); do
    if [[ -s $work/display ]] || ! kill -0 "$server" 2>/dev/null; then
        break
    fi
    sleep 0.1
done
if [[ ! -s $work/display ]]; then
    cat "$work/log"
    echo "Xvfb does not start"
    exit 1
fi
mkdir "$work/home"
DISPLAY=:$(<"$work/display")
export DISPLAY HOME=$work/home TREMBLER_TEST_WINDOW=1
export SDL_VIDEODRIVER=x11 SDL_AUDIODRIVER=dummy LIBGL_ALWAYS_SOFTWARE=1 LP_NUM_THREADS=0
unset WAYLAND_DISPLAY XDG_DATA_HOME
tests='FirstLesson.*:KeysAlone.*:KeyboardAlone.*:GamepadAlone.*:EditorGamepad.*:SecondPlayer.*:OneGamepad.*:CommandsPage.*'
tests+=':MouseOnTheField.*:Resizing.*:Program.ALevelIsChosenOnTheTitleScreen'
"$program" --gtest_filter="$tests" --gtest_brief=1
