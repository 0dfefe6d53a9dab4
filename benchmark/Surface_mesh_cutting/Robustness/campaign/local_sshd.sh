#!/usr/bin/env bash
# An ssh server of one's own on this machine's loopback device, to try run_with_parallel.sh --sshlogin.
# Needs Debian's package openssh-server.
#   local_sshd.sh start FOLDER     prints what to pass to run_with_parallel.sh
#   local_sshd.sh stop FOLDER
# The keys made for it, and its number, are in FOLDER; nothing of the user's is read or changed.
set -euo pipefail
folder=$(mkdir -p "$2" && cd "$2" && pwd)

start() {
  local port
  port=$(python3 -c 'import socket; s = socket.socket(); s.bind(("", 0)); print(s.getsockname()[1])')
  chmod 700 "$folder"
  rm -f "$folder"/host_key* "$folder"/user_key*
  ssh-keygen -q -t ed25519 -N '' -f "$folder/host_key"
  ssh-keygen -q -t ed25519 -N '' -f "$folder/user_key"
  cp "$folder/user_key.pub" "$folder/authorized_keys"
  echo "[127.0.0.1]:$port $(cut -d ' ' -f 1-2 "$folder/host_key.pub")" > "$folder/known_hosts"
  cat > "$folder/sshd_config" <<END
ListenAddress 127.0.0.1:$port
HostKey $folder/host_key
AuthorizedKeysFile $folder/authorized_keys
PidFile $folder/sshd.pid
StrictModes no
UsePAM no
PermitRootLogin prohibit-password
MaxStartups 100
END
  [ "$(id -u)" -ne 0 ] || mkdir -p /run/sshd
  "$(command -v sshd || echo /usr/sbin/sshd)" -f "$folder/sshd_config" -E "$folder/sshd.log"
  echo "--ssh 'ssh -p $port -i $folder/user_key -o UserKnownHostsFile=$folder/known_hosts -o IdentitiesOnly=yes'" \
    "--sshlogin $(id -un)@127.0.0.1"
}

stop() {
  [ ! -e "$folder/sshd.pid" ] || kill "$(cat "$folder/sshd.pid")"
}

case $1 in
  start) start ;;
  stop) stop ;;
  *) echo "usage: $0 start|stop FOLDER" >&2; exit 2 ;;
esac
