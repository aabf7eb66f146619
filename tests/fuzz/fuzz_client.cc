#include <algorithm>
#include <chrono>
#include <deque>
#include <memory>

#include "bt_core/live/client/client_extension.h"
#include "bt_core/live/groot2/client_groot2.h"
#include "tests/fuzz/frames.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/history_check.h"

namespace coppice::fuzz {
namespace {

using Parts = ClientSession::Parts;

constexpr std::size_t kRunSize = 16;
constexpr Duration kTimeStep = std::chrono::milliseconds(50);

class Listener final : public LiveListener {
 public:
  void OnTree(const TreeDescription& tree) override { check.OnTree(tree); }
  void OnState(const HistoryState& state) override { check.OnState(state); }
  void OnTick(const TickEvents& events) override { check.OnTick(events); }
  void OnConnection(const LiveConnection& connection) override {
    Require(!connection.is_live || connection.tree < connection.trees.size());
  }
  void OnNotice(const LiveNotice& notice) override {
    const NodeIndex node = notice.event.stop.node;
    Require(node == kNoNode || node < check.nodes());
  }

  void OnPicture(const LivePicture& picture) override {
    Require(pictures_.Put(picture).ok() && !picture.rgb.empty());
  }

  void ForgetPictures() { pictures_.Clear(); }

  HistoryCheck check;

 private:
  PictureSet pictures_;
};

// A client with a robot that says what the fuzzer wants.
class Talk {
 public:
  explicit Talk(bool is_groot2) : is_groot2_(is_groot2) { Connect(); }
  ~Talk() {
    session_->Abandon("it is over");
    Require(replies_ == commands_);
  }
  Talk(const Talk&) = delete;
  Talk& operator=(const Talk&) = delete;

  void Hear(const LooseFrame& message) {
    const std::string_view body = message.payload;
    switch (message.type) {
      case 'R':
        return Answer(body, 'a');
      case 'O':
        return Answer(body, 'b');
      case 'e':
        return Tell({"error", std::string(body)});
      case 'F':
        return Push(body);
      case 'f':
        return Tell({Header('F') + std::string(kRunSize, '\0'), std::string(body)});
      case 'E':
        return Tell({Header('E') + std::string(kRunSize, '\0'), std::string(body)});
      case 'N':
        return Tell({Header('N'), std::string(body)});
      case 'w':
        return Tell({std::string(body.substr(0, body.find('\n'))),
                     std::string(body.substr(std::min(body.size(), body.find('\n'))))});
      case 'c':
        return Command(body);
      default:
        now_ += kTimeStep * message.type;
        session_->OnTime(now_);
        Reconnect();
    }
  }

  int reached() const { return listener_.check.reached(); }

 private:
  void Connect() {
    asked_.clear();
    listener_.ForgetPictures();
    const auto sender = [this](const Parts& parts) {
      const bool wants_reply = parts[0].find_first_not_of('\0', 2) != std::string::npos;
      if (wants_reply) asked_.push_back(parts[0]);
    };
    if (is_groot2_) {
      session_ = std::make_unique<ClientGroot2>(options_, listener_, groot2_, sender);
    } else {
      session_ = std::make_unique<ClientExtension>(options_, listener_, history_, sender);
    }
    session_->OnTime(now_);
  }

  // As LiveClient does it.
  void Reconnect() {
    if (session_->failure().empty()) return;
    session_->Abandon(session_->failure());
    Connect();
  }

  void Tell(const Parts& parts) {
    session_->OnMessage(parts, now_);
    Reconnect();
    session_->OnTime(now_);
    Reconnect();
  }

  void Answer(std::string_view body, char run) {
    if (asked_.empty()) return;
    const std::string header = asked_.front() + std::string(kRunSize, run);
    asked_.pop_front();
    Tell({header, std::string(body)});
  }

  // Frames of a history, numbered on.
  void Push(std::string_view frames) {
    std::string body;
    for (const std::uint64_t number : {next_, next_ + 1}) {
      for (int shift = 0; shift < 64; shift += 8) body += static_cast<char>(number >> shift);
    }
    ++next_;
    for (LooseFrame frame; TakeFrame(frames, frame);) {
      const Bytes sealed = Seal(frame, packer_);
      body.append(sealed.begin(), sealed.end());
    }
    Tell({Header('F') + std::string(kRunSize, '\0'), body});
  }

  void Command(std::string_view text) {
    if (!session_->is_live() || text.empty()) return;
    LiveCommand command;
    command.kind = static_cast<LiveCommand::Kind>(static_cast<unsigned char>(text[0]) % 7);
    command.id = static_cast<HookId>(text.size() % 3);
    command.hook.path = text.substr(1);
    command.key = command.hook.path;
    ++commands_;
    session_->Send(command, [this](const LiveReply&) { ++replies_; });
    session_->OnTime(now_);
    Reconnect();
  }

  std::string Header(char type) const { return {'\2', type, '\0', '\0', '\0', '\0'}; }

  const bool is_groot2_;
  const LiveClientOptions options_ = [] {
    LiveClientOptions options;
    options.with_pictures = true;
    return options;
  }();
  Listener listener_;
  ClientHistory history_{listener_};
  Groot2History groot2_{listener_, "robot"};
  std::unique_ptr<ClientSession> session_;
  std::deque<std::string> asked_;  // headers of requests without an answer
  Packer packer_;
  Duration now_ = std::chrono::seconds(1);
  std::uint64_t next_ = 0;
  int commands_ = 0;
  int replies_ = 0;
};

}  // namespace

int FuzzClient(std::string_view bytes) {
  if (bytes.empty()) return 0;
  Talk talk(bytes[0] == 'G');
  bytes.remove_prefix(1);
  for (LooseFrame message; TakeFrame(bytes, message);) talk.Hear(message);
  return talk.reached();
}

}  // namespace coppice::fuzz
