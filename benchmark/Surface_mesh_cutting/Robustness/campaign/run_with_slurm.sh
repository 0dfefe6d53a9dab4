#!/usr/bin/env bash
# Works on a campaign (see campaign.py) by an array of Slurm jobs, one per shard, and waits for it.
#   run_with_slurm.sh CAMPAIGN [options of sbatch]
# Slurm repeats the shards of nodes that fail; starting the script again does what is left.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
campaign=$(cd "$1" && pwd)
shift

shards=$(python3 -B "$here/campaign.py" shards "$campaign")
mkdir -p "$campaign/log"
sbatch --wait --array="0-$((shards - 1))" --output="$campaign/log/%a.txt" --open-mode=append "$@" \
  "$here/shard.sbatch" "$here/campaign.py" "$campaign" || echo "some jobs failed" >&2
exec python3 -B "$here/campaign.py" status "$campaign"
