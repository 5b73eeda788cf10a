#!/bin/sh
# Builds core four ways and compares what it computes, bit by bit; also without the CPU's fused multiply-add, which
# the system's mathematics would use. Then looks into the objects: core may take nothing from libm that rounds.
#
#   tests/determinism/compare.sh [BUILD_DIRECTORY]        default: build/determinism
set -eu
cd "$(dirname "$0")/../.."
out=${1:-build/determinism}
ccache=$(command -v ccache || true)
passed=0
failed=0

# What glibc 2.33 and later call these, and what it called them before.
without_fma="glibc.cpu.hwcaps=-FMA,-AVX2,-FMA_Usable,-AVX2_Usable"
# IEEE 754 leaves these no choice, so every libm gives the same bits.
exact="sqrt fabs floor ceil trunc rint nearbyint round copysign fmod"

check() { # name, 0 or 1, what went wrong
    if [ "$2" = 0 ]; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "FAILED $1: $3"
    fi
}

# One line "compiler level source object" per object to be made.
objects() {
    for compiler in g++ clang++; do
        for level in O0 O3; do
            mkdir -p "$out/$compiler-$level"
            for source in core/src/*.cpp tests/determinism/hash.cpp; do
                echo "$compiler -$level $source $out/$compiler-$level/$(basename "$source" .cpp).o"
            done
        done
    done
}

rm -f "$out"/*/*.o "$out"/*/hash "$out"/*.txt
objects | xargs -P "$(nproc)" -L 1 sh -c '
    exec '"$ccache"' "$0" "$1" -std=c++20 -ffp-contract=off -Icore/include -c "$2" -o "$3"'
for build in g++-O0 g++-O3 clang++-O0 clang++-O3; do
    "${build%-*}" "$out/$build"/*.o -o "$out/$build/hash"
    "$out/$build/hash" >"$out/$build.txt"
done
GLIBC_TUNABLES=$without_fma "$out/g++-O3/hash" >"$out/g++-O3-without-fma.txt"
GLIBC_TUNABLES=$without_fma "$out/clang++-O3/hash" >"$out/clang++-O3-without-fma.txt"

reference=$out/g++-O0.txt
cat "$reference"
check "samples" "$(grep -c refused "$reference" || true)" "core refuses one of them"
while read -r line; do
    for other in "$out"/*.txt; do
        grep -qxF "$line" "$other" && wrong=0 || wrong=1
        check "$(basename "$other" .txt)" $wrong "differs from g++-O0 in: $line"
    done
done <"$reference"

if [ "$("$out/g++-O3/hash" libm)" = "$(GLIBC_TUNABLES=$without_fma "$out/g++-O3/hash" libm)" ]; then
    echo "note: this machine's libm does not change without fused multiply-add, so leaving it out proves nothing here"
else
    echo "note: libm itself changes without fused multiply-add; core does not"
fi

# Whatever libm exports and core leaves undefined, it would take from there.
libm=$(g++ -print-file-name=libm.so.6)
nm -D --defined-only "$libm" | awk '{ sub(/@.*/, "", $3); print $3 }' | sort -u >"$out/libm-exports"
[ -s "$out/libm-exports" ] && wrong=0 || wrong=1
check "libm" $wrong "$libm exports nothing"
for build in g++-O0 g++-O3 clang++-O0 clang++-O3; do
    for object in "$out/$build"/*.o; do
        [ "$(basename "$object")" = hash.o ] && continue
        taken=$(nm -u "$object" | awk '{ print $2 }' | sort -u | comm -12 - "$out/libm-exports")
        for symbol in $taken; do
            case " $exact " in
                *" ${symbol%f} "* | *" $symbol "*) ;;
                *) check "$build/$(basename "$object")" 1 "takes $symbol from libm" ;;
            esac
        done
        [ -s "$object" ] && wrong=0 || wrong=1
        check "$build/$(basename "$object")" $wrong "is empty"
    done
done
# hash.o takes sin and others on purpose: a search that does not find them there finds nothing anywhere.
nm -u "$out/g++-O3/hash.o" | awk '{ print $2 }' | sort -u | comm -12 - "$out/libm-exports" | grep -qx pow && wrong=0 || wrong=1
check "the search itself" $wrong "does not find pow in hash.o"

echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
