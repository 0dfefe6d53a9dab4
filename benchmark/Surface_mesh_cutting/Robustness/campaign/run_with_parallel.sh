#!/usr/bin/env bash
# Works on a campaign (see campaign.py) by GNU parallel: on this machine, or on others over ssh.
#   run_with_parallel.sh CAMPAIGN [JOBS] [--sshlogin HOST,...] [other options of parallel]
# Hosts need this folder, the program, the campaign and the meshes at the same place (a network file
# system). A worker that fails or is killed is started anew, up to three times; starting the script
# again does what is left.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
campaign=$(cd "$1" && pwd)
jobs=${2:-$(nproc)}
shift $(($# < 2 ? $# : 2))

shards=$(python3 -B "$here/campaign.py" shards "$campaign")
seq 0 $((shards - 1)) |
  parallel --will-cite --jobs "$jobs" --retries 4 "$@" python3 -B "$here/campaign.py" work "$campaign" {} ||
  echo "some workers failed" >&2
exec python3 -B "$here/campaign.py" status "$campaign"
