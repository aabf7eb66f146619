// What can be chosen about a live view. docs/live.md explains it.
#ifndef COPPICE_BT_CORE_LIVE_SERVER_LIVE_OPTIONS_H_
#define COPPICE_BT_CORE_LIVE_SERVER_LIVE_OPTIONS_H_

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "bt_core/base/clock.h"
#include "bt_core/base/outcome.h"
#include "bt_core/frames/history.h"

namespace coppice {

class LivePictures;

/// About one tree.
struct LiveTreeOptions {
  /// What clients see; empty: the ID of the main tree.
  std::string name;
  /// Nobody may stop or change the tree.
  bool read_only = false;
  /// Whether the tree may be stopped and changed now, or why not ("the robot moves"); no function:
  /// it may. Called on threads of the live view and on the ticking thread; must be quick and must
  /// not throw.
  std::function<Outcome()> permission;
  /// The first tick waits so long for a client that says `continue`, so that breakpoints can be set
  /// before. 0: it does not wait.
  Duration wait_for_client{0};
  /// The number of the run, if it is to be the same as that of a record (RecorderOptions::run);
  /// zeros: a random one.
  std::array<std::uint8_t, 16> run{};
  /// Gets what the view notes in its history, for a record of the same run (Recorder::Note): that
  /// the tree stood still (frames/pause_note.h). Ticking thread; no function: nobody.
  std::function<void(const HistoryNote&)> on_note;
  /// How much of the past is kept for clients that come later or come back.
  std::size_t history_bytes = 32 << 20;
};

/// About the endpoint, and about the tree if it is the only one.
struct LiveOptions : LiveTreeOptions {
  /// Requests and pushes; notifications of the Groot2 protocol leave at port + 1. 0 takes a free
  /// pair.
  std::uint16_t port = 1667;
  /// Where to listen: a local address, an interface ("eth0"), or "*" for every network. All but
  /// this computer ("127.0.0.1", "lo") need a token.
  std::string address = "127.0.0.1";
  /// For those who may control the tree, at least 16 characters; see LiveServer::read_token. With
  /// it, connections are encrypted and nobody else is let in.
  std::string token;
  /// Tell the networks where it listens of the robot, so that editors offer it (multicast DNS): the
  /// names of computer and tree, and the port.
  bool announce = false;
  /// Also serve the editor for browsers, and the live protocol over WebSocket.
  bool web = false;
  /// Where; 0 takes a free port.
  std::uint16_t web_port = 8667;
  /// Where the files of the page lie (docs/editor.md).
  std::string web_folder;
  /// A client that was silent for so long is taken for dead: what it holds is released.
  Duration deadline = std::chrono::seconds(5);
  /// What the robot shows to people, for those who watch it (pictures/live_pictures.h); null:
  /// nothing.
  std::shared_ptr<const LivePictures> pictures;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_SERVER_LIVE_OPTIONS_H_
