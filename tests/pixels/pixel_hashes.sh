#!/usr/bin/env bash
# pixel_hashes.sh [-b BACKEND,...] PROGRAM FOLDER...: hashes of the images that PROGRAM, an etalon,
# renders of every scene file below the folders, one line for each scene, size and backend, with
# the numbers of rays. Two programs render the same pixels if their lists do not differ.
#
# Backends (default: the exact ones) are held to each other: exit status 1 if they disagree on a
# scene or one of them fails, or if a folder holds no scene. The brute force backend, none, takes
# part at a size that keeps the number of its tests bounded; where this is small, the others render
# a larger image as well.
set -uo pipefail
export LC_ALL=C

readonly max_samples=12000        # of an image
readonly max_tests=10000000       # camera samples times primitives, of an image by brute force
readonly max_samples_per_pixel=4  # a lens or a soft shadow needs a few

usage() {
    echo "usage: $0 [-b BACKEND,...] PROGRAM FOLDER..." >&2
    exit 2
}

backends=(none grid bvh embree embree-user)
while getopts b: option; do
    case $option in
        b) IFS=, read -ra backends <<<"$OPTARG" ;;
        *) usage ;;
    esac
done
shift $((OPTIND - 1))
(($# >= 2)) || usage
program=$1
shift

perl -MCompress::Zlib -e 1 || exit 2 # of the package perl

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
status=0

# read_info SCENE: sets primitives, width, height and spp.
read_info() {
    "$program" info --json "$1" >"$scratch/info.json" 2>/dev/null || return
    read -r primitives width height spp < <(awk -F'[:,]' '
        /"primitives": \{/ { inside = 1; next }
        inside && /\}/ { inside = 0 }
        inside { primitives += $2 }
        /"width":/ { width = $2 }
        /"height":/ { height = $2 }
        /"samples_per_pixel":/ { spp = $2 }
        END { print primitives + 0, width + 0, height + 0, spp + 0 }' "$scratch/info.json")
    ((spp <= max_samples_per_pixel)) || spp=$max_samples_per_pixel
}

# size_for PIXELS: the scene's proportions with about so many pixels, never more than it has itself.
size_for() {
    awk -v pixels="$1" -v w="$width" -v h="$height" 'BEGIN {
        scale = sqrt(pixels / (w * h)); if (scale > 1) scale = 1
        x = int(w * scale); y = int(h * scale)
        printf "%dx%d\n", x < 1 ? 1 : x, y < 1 ? 1 : y }'
}

# The pixels of an EXR file with ZIP compression, whatever compressed them: the header holds the time
# that rendering took, and a compressor may pack the same pixels in other ways.
pixels_of() {
    perl -MCompress::Zlib -0777 -ne '
        my $at = 8;
        while (substr($_, $at, 1) ne "\0") {
            $at = 1 + index($_, "\0", 1 + index($_, "\0", $at));
            $at += 4 + unpack("V", substr($_, $at, 4));
        }
        $at = unpack("Q<", substr($_, $at + 1, 8));
        while ($at < length) {
            my $size = unpack("V", substr($_, $at + 4, 4));
            my $block = substr($_, $at + 8, $size);
            $at += 8 + $size;
            my $packed = uncompress($block);
            if (defined $packed) {  # else the block was stored as it is
                my ($sum, $half) = (128, (length($packed) + 1) >> 1);
                my @bytes = map { $sum = ($sum + $_ - 128) & 255 } unpack("C*", $packed);
                $block = pack("C*", map { @bytes[$_, $_ + $half] } 0 .. $half - 1);
            }
            print $block;
        }' "$1"
}

# The object `rays` of --stats, on one line.
ray_counts() {
    sed -n '/"rays": {/,/}/p' "$1" | tr -d ' \n"' | sed 's/^rays:{//; s/},*$//'
}

# result_of SCENE SIZE BACKEND: hash and rays, by the scene's own integrator.
result_of() {
    rm -f "$scratch"/image.exr "$scratch"/stats.json
    "$program" render "$1" --resolution "$2" --spp "$spp" --backend "$3" \
        --threads 1 --quiet --display-values -o "$scratch/image.exr" --stats "$scratch/stats.json" \
        >/dev/null 2>"$scratch/errors" || {
        echo "failed: $(head -1 "$scratch/errors")"
        return 1
    }
    echo "$(pixels_of "$scratch/image.exr" | sha256sum | cut -c 1-16)" \
        "$(ray_counts "$scratch/stats.json")"
}

# compare_backends NAME SCENE SIZE BACKEND...: a line for each backend.
compare_backends() {
    local name=$1 scene=$2 size=$3 backend result first=
    shift 3
    for backend; do
        result=$(result_of "$scene" "$size" "$backend") || status=1
        echo "$name $size spp $spp $backend $result"
        [[ $result == "${first:=$result}" ]] || {
            echo "$name $size: $backend differs from $1" >&2
            status=1
        }
    done
}

# hash_scene NAME SCENE
hash_scene() {
    local primitives=0 width=0 height=0 spp=0 samples small large others=() backend
    read_info "$2" || {
        echo "$1 cannot be read"
        status=1
        return
    }
    samples=$((spp > 0 ? spp : 1))
    large=$(size_for $((max_samples / samples)))
    small=$(size_for $((max_tests / ((primitives > 0 ? primitives : 1) * samples))))
    ((primitives * max_samples > max_tests)) || small=$large
    compare_backends "$1" "$2" "$small" "${backends[@]}"
    [[ $small != "$large" ]] || return
    for backend in "${backends[@]}"; do [[ $backend == none ]] || others+=("$backend"); done
    compare_backends "$1" "$2" "$large" "${others[@]}"
}

# is_scene FILE: a PBRT file without a world is a part of another.
is_scene() {
    [[ $1 != *.pbrt ]] || grep -q WorldEnd "$1"
}

for folder; do
    found=0
    while read -r scene; do
        is_scene "$scene" || continue
        hash_scene "${scene#"$folder"/}" "$scene"
        found=1
    done < <(find "$folder" -type f \
        \( -name '*.p3f' -o -name '*.nff' -o -name '*.prt' -o -name '*.sce' -o -name '*.pbrt' \) | sort)
    ((found)) || {
        echo "$folder: no scene" >&2
        status=1
    }
done
exit "$status"
