#!/bin/sh
# Runs a compiler, or ccache before it, without the precompiled header that an earlier run left: to make it
# anew they would read that one, and what has changed since would not be in it.
for argument; do
  case $argument in
    *.gch | *.pch) rm -f "$argument" ;;
  esac
done
exec "$@"
