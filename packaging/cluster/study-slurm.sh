#!/usr/bin/env bash
#SBATCH --job-name=ravnoves-study
#SBATCH --cpus-per-task=1
#SBATCH --requeue
#SBATCH --signal=B:TERM@60
#SBATCH --open-mode=append
# Runs a study in shards as a Slurm job array in a folder that all nodes see.
set -euo pipefail

usage() {
    cat <<END
usage: study-slurm.sh CASE SHARDS RESULT [OPTION-OF-SBATCH...]

Submits a job array that solves the study of the case file CASE in SHARDS parts (at most 1024), RESULT.K.part,
and a job that then writes RESULT. A task that is stopped (time limit, preemption) keeps what it has done
and goes on from there. Lost parts are named by the second job; run them again by
  sbatch --array=3,7 study-slurm.sh CASE SHARDS RESULT
and then ravnoves-cli study --merge RESULT.*.part -o RESULT.

RAVNOVES_CLI says which program to run, otherwise ravnoves-cli.
END
}

case ${1:-} in
    -h | --help)
        usage
        exit 0
        ;;
esac
if [ $# -lt 3 ]; then
    usage >&2
    exit 2
fi
file=$1 shards=$2 result=$3
cli=${RAVNOVES_CLI:-ravnoves-cli}

if [ -n "${SLURM_ARRAY_TASK_ID:-}" ]; then
    # In the shell's place, so that the signal reaches it.
    exec "$cli" study "$file" --threads "${SLURM_CPUS_PER_TASK:-1}" \
        --shard "$SLURM_ARRAY_TASK_ID/$shards" -o "$result.$SLURM_ARRAY_TASK_ID.part"
elif [ -n "${SLURM_JOB_ID:-}" ]; then
    shopt -s nullglob
    exec "$cli" study --merge "$result".*.part -o "$result"
fi
shift 3
array=$(sbatch --parsable --array="1-$shards" "$@" "${BASH_SOURCE[0]}" "$file" "$shards" "$result")
sbatch --dependency="afterany:${array%%;*}" "$@" "${BASH_SOURCE[0]}" "$file" "$shards" "$result"
