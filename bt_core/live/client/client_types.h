// What a live client is told and what it may ask for. Plain values; client.h uses them.
#ifndef COPPICE_BT_CORE_LIVE_CLIENT_CLIENT_TYPES_H_
#define COPPICE_BT_CORE_LIVE_CLIENT_CLIENT_TYPES_H_

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bt_core/base/outcome.h"
#include "bt_core/frames/history.h"
#include "bt_core/live/debug/debugger_hooks.h"
#include "bt_core/live/pictures/picture_set.h"

namespace coppice {

struct LiveClientOptions {
  std::string name = "coppice";  ///< what the robot is told
  /// Of a robot that asks for one (docs/live.md); empty: none. TokenFromEnvironment() gives it.
  std::string token;
  /// Of several trees: the name or the number of the one to follow; empty: the first.
  std::string tree;
  /// Begin with the past that the robot has kept, or with the present.
  bool with_past = true;
  /// Be told what the robot shows to people, if it shows something.
  bool with_pictures = false;
  /// Never use the extension of the protocol, whatever the robot knows.
  bool groot2_only = false;

  // For robots that know the Groot2 protocol only.
  Duration poll_period = std::chrono::milliseconds(50);
  Duration board_period = std::chrono::milliseconds(500);
};

/// How things stand between client and robot.
struct LiveConnection {
  enum class Protocol : std::uint8_t { kNone, kCoppice, kGroot2 };

  bool is_live = false;
  std::string problem;  ///< why it is not live; for people
  Protocol protocol = Protocol::kNone;
  std::string refusal;             ///< why this client may not control the tree now; empty: it may
  std::vector<std::string> trees;  ///< their names; the number of a tree is its place
  std::size_t tree = 0;            ///< the one that is followed
  /// Another one after every start of the robot's program; the client numbers those of Groot2
  /// robots itself.
  RunId run{};
};

/// Something that a client asks for. Make it with the functions below.
struct LiveCommand {
  enum class Kind : std::uint8_t {
    kPause,
    kStepNode,
    kStepTick,
    kContinue,    ///< `result` may be forced on the node that the tree stands at
    kAddHook,     ///< `hook`
    kRemoveHook,  ///< `id`; kNoHook: all of this client
    kWrite,       ///< `key` in `scope` becomes what the text `value` stands for
  };
  Kind kind = Kind::kPause;
  Hook hook;
  HookId id = kNoHook;
  std::optional<Status> result;
  std::string scope;  ///< path of a SubTree instance; empty: the main tree
  std::string key;
  std::string value;
  bool is_json = false;  ///< of `value`: JSON, which says its type; else a text as in the XML
};

LiveCommand MakeCommand(LiveCommand::Kind kind);
LiveCommand SetHook(Hook hook);
LiveCommand WriteKey(std::string scope, std::string key, std::string value);

/// What came of a command: the hook if one was added, else nothing but that it was done.
using LiveReply = Expected<HookAnswer>;

/// What the robot's debugger has told.
struct LiveNotice {
  DebugEvent event;
  std::string path;  ///< of the node, if there is one
};

/// A hook that is in the robot though this client has not set it: of a robot with the Groot2
/// protocol, which knows no clients and keeps what they leave. It is removed as one's own.
struct ForeignHook {
  HookId id = kNoHook;
  Hook hook;  ///< by its path
};

/// "FAILURE x3", "delay 0.5 s", "before, if battery < 20, from hit 3 on".
std::string ToString(const Hook& hook);

/// Called on the client's thread, which waits meanwhile; must not call the client but Send.
///
/// The history comes as from a record: the tree, how it stands, then every tick. After a
/// reconnection it goes on where it was, if it is the same run and the robot has kept what was
/// missed; else there is a gap, or another tree.
class LiveListener : public HistoryHandler {
 public:
  virtual void OnConnection(const LiveConnection&) {}
  virtual void OnNotice(const LiveNotice&) {}
  /// All that are there; whenever they have become others.
  virtual void OnForeignHooks(const std::vector<ForeignHook>&) {}
  /// The robot shows this to people now, in the place of what had the same name. All of a
  /// connection together keep the limits of a PictureSet, and those of the next begin anew.
  virtual void OnPicture(const LivePicture&) {}
  /// The bytes of a frame of the history, after the calls that its content led to. A Groot2 robot
  /// sends none.
  virtual void OnFrame(const std::uint8_t*, std::size_t) {}
};

/// $COPPICE_LIVE_TOKEN, or empty.
std::string TokenFromEnvironment();

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_CLIENT_CLIENT_TYPES_H_
