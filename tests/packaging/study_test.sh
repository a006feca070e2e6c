#!/usr/bin/env bash
# study_test.sh SOURCE-FOLDER RAVNOVES-CLI: the scripts for clusters give what one run gives.
set -euo pipefail
source=$1
export RAVNOVES_CLI=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
fault() {
    printf 'FAULT: %s\n' "$*"
    exit 1
}

study='"study": {"vary": {"/crank_radius_mm": {"plus_minus": 0.02}},
    "watch": {"/metrics/M_ups/range_Nm": {}}, "samples": 2000}'
sed '$d' "$source/resources/examples/tmz-650d.case.json" >case.json
printf ', %s}\n' "$study" >>case.json
"$RAVNOVES_CLI" study case.json -o whole.json

# Slurm's array, without Slurm: its tasks, and the job after them.
slurm=$source/packaging/cluster/study-slurm.sh
for k in 3 1; do
    SLURM_ARRAY_TASK_ID=$k bash "$slurm" case.json 3 slurm.json
done
said=$(SLURM_JOB_ID=1 bash "$slurm" case.json 3 slurm.json 2>&1) && fault "a lost part is not missed"
grep -F -- '--shard 2/3' <<<"$said" >/dev/null || fault "the lost part is not named: $said"
SLURM_ARRAY_TASK_ID=2 bash "$slurm" case.json 3 slurm.json
SLURM_JOB_ID=1 bash "$slurm" case.json 3 slurm.json
cmp whole.json slurm.json

command -v parallel >/dev/null || {
    echo "GNU parallel is not there: its script was not run"
    exit 0
}
export PARALLEL_HOME=$folder/home
bash "$source/packaging/cluster/study-parallel.sh" case.json 4 parallel.json
cmp whole.json parallel.json
! compgen -G 'parallel.json.*' >/dev/null || fault "parts are left behind"
# Two "hosts", both this machine; a part that is there is taken as it is.
printf '1/:\n:\n' >hosts
"$RAVNOVES_CLI" study case.json --shard 2/5 -o hosts.json.2.part
bash "$source/packaging/cluster/study-parallel.sh" --hosts hosts case.json 5 hosts.json -j 2
cmp whole.json hosts.json

command -v rsync >/dev/null || {
    echo "rsync is not there: no other host was tried"
    exit 0
}
# Two hosts to which the case goes and from which the parts come back: folders, by an ssh that enters them.
cat >ssh <<'END'
#!/usr/bin/env bash
while [[ $1 == -* ]]; do
    case $1 in -[FJilop]) shift ;; esac
    shift
done
cd "$HOSTS/$1"
shift
[ "$1" != -- ] || shift
SHELL=/bin/bash exec bash -c "$*"  # a login says which shell it is
END
chmod +x ssh
mkdir -p hosts.d/alpha hosts.d/beta
printf '1/alpha\n1/beta\n' >hosts
HOSTS=$folder/hosts.d PARALLEL_SSH=$folder/ssh \
    bash "$source/packaging/cluster/study-parallel.sh" --hosts hosts case.json 4 remote.json
cmp whole.json remote.json
[ -z "$(find hosts.d -type f)" ] || fault "files are left behind on the hosts"
