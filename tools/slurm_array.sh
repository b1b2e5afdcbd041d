#!/bin/sh
# slurm_array.sh shards N IMAGE SCENE [OPTION...]: submits the N shards of a picture to Slurm as an array, and a job
#   that merges them into IMAGE when all are done.
# slurm_array.sh frames A-B IMAGE SCENE [OPTION...]: submits each frame of an animation as a task; IMAGE has ####.
# Only what is missing is submitted: run the same line again for tasks that failed. Prints the numbers of the jobs.
# PROJECT (./Project, or an installed one) is the program, CPUS (1) the cores of a task; sbatch reads SBATCH_PARTITION and the like. All
# nodes must see the folder.
set -eu

fail() { echo "slurm_array.sh: $*" >&2; exit 2; }
[ $# -ge 4 ] || { sed -n '2,8s/^# //p' "$0" >&2; exit 2; }
kind=$1
range=$2
image=$3
scene=$4
shift 4
project=${PROJECT:-./Project}
[ -n "${PROJECT:-}" ] || [ -x "$project" ] || project=Project
command -v "$project" > /dev/null || fail "$project is no program; PROJECT names it"
command -v sbatch > /dev/null || fail "sbatch is missing: is this a machine that submits to Slurm?"
stem=${image%.*}

# whole NUMBER: whether it is one, at least 0.
whole() { case $1 in '' | *[!0-9]*) return 1 ;; esac; }
# quoted WORD...: as a shell reads them again.
quoted() {
    for word in "$@"; do printf "'%s' " "$(printf '%s' "$word" | sed "s/'/'\\\\''/g")"; done
}
# framed NUMBER: IMAGE with the number for its run of #.
framed() {
    run=$(printf '%s' "$image" | grep -o '##*' | head -n 1)
    printf '%s' "$image" | sed "s/$run/$(printf "%0${#run}d" "$1")/"
}
# submitted OPTION... < SCRIPT: the job's number.
submitted() { sbatch --parsable --export=ALL --output="$stem.slurm-%A_%a.log" --open-mode=append "$@" | cut -d';' -f1; }

case $kind in
    shards)
        whole "$range" || fail "shards $range: must be a number from 1"
        [ "$range" -ge 1 ] || fail "shards $range: must be a number from 1"
        first=1
        last=$range
        task="--shard \$SLURM_ARRAY_TASK_ID/$range"
        made() { echo "$stem.$1-of-$range.part"; }
        ;;
    frames)
        first=${range%-*}
        last=${range#*-}
        if ! whole "$first" || ! whole "$last" || [ "$first" -gt "$last" ]; then
            fail "frames $range: must be A-B"
        fi
        case $image in *#*) ;; *) fail "$image: frames need #### in the name" ;; esac
        task="--frames $range --subset \$SLURM_ARRAY_TASK_ID"
        made() { framed "$1"; }
        ;;
    *) fail "$kind: must be shards or frames" ;;
esac

missing=
i=$first
while [ "$i" -le "$last" ]; do
    [ -e "$(made "$i")" ] || missing=$missing,$i
    i=$((i + 1))
done
missing=${missing#,}

array=
if [ -n "$missing" ]; then
    # A task that Slurm starts again, because its node died, goes on from its checkpoint.
    array=$(submitted --array="$missing" --requeue --cpus-per-task="${CPUS:-1}" --job-name="$stem" << TASK
#!/bin/sh
exec $(quoted "$project" "$scene" "$@" -o "$image")--quiet --resume --threads ${CPUS:-1} $task
TASK
    )
    echo "tasks $missing: job $array"
else
    echo "nothing is missing"
fi

[ "$kind" = shards ] || exit 0
parts=
i=1
while [ "$i" -le "$range" ]; do
    parts="$parts $(quoted "$(made "$i")")"
    i=$((i + 1))
done
merge=$(submitted ${array:+--dependency=afterok:$array --kill-on-invalid-dep=yes} --requeue --job-name="$stem-merge" << MERGE
#!/bin/sh
exec $(quoted "$project" merge "$image")$parts
MERGE
)
echo "merge into $image: job $merge"
