#!/bin/sh
# Runs a compiler, or ccache before it, without the precompiled header that an earlier run left: to make it
# anew they would read that one, and what has changed since would not be in it.
before=
for argument; do
  case $before$argument in
    -o*.gch | -o*.pch) rm -f "$argument" ;;
  esac
  before=$argument
done
exec "$@"
