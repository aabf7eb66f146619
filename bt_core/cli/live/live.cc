#include <algorithm>
#include <chrono>
#include <future>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "bt_core/base/command_line.h"
#include "bt_core/base/plain.h"
#include "bt_core/cli/live/interrupt.h"
#include "bt_core/cli/live/live_commands.h"
#include "bt_core/cli/live/live_json.h"
#include "bt_core/cli/live/live_scene.h"
#include "bt_core/cli/live/live_screen.h"
#include "bt_core/cli/live/live_terminal.h"
#include "bt_core/cli/verbs.h"

namespace coppice {
namespace {

using namespace std::chrono_literals;  // NOLINT(google-build-using-namespace)
using Kind = LiveCommand::Kind;

constexpr Duration kLookPeriod = 33ms;
constexpr Duration kPatience = 5s;  // with --once and commands
constexpr Duration kQuiet = 100ms;  // after which --once takes a scene for the present one

Duration Now() { return std::chrono::steady_clock::now().time_since_epoch(); }

// Keeps the scene, and with --json prints what happens as it comes.
class Watch final : public LiveSceneKeeper {
 public:
  explicit Watch(bool prints) {
    if (prints) printer_ = std::make_unique<LiveJsonPrinter>(std::cout);
  }
  void OnConnection(const LiveConnection& connection) override {
    LiveSceneKeeper::OnConnection(connection);
    Print(connection);
  }
  void OnTree(const TreeDescription& tree) override {
    LiveSceneKeeper::OnTree(tree);
    Print(tree);
  }
  void OnState(const HistoryState& state) override {
    LiveSceneKeeper::OnState(state);
    Print(state);
  }
  void OnTick(const TickEvents& events) override {
    LiveSceneKeeper::OnTick(events);
    Print(events);
  }
  void OnGap(const HistoryGap& gap) override {
    LiveSceneKeeper::OnGap(gap);
    Print(gap);
  }
  void OnNotice(const LiveNotice& notice) override {
    LiveSceneKeeper::OnNotice(notice);
    Print(notice);
  }
  void OnForeignHooks(const std::vector<ForeignHook>& hooks) override {
    LiveSceneKeeper::OnForeignHooks(hooks);
    Print(hooks);
  }
  void OnNote(const HistoryNote& note) override { Print(note); }
  void OnEnd(const HistoryEnd& end) override { Print(end); }

 private:
  template <class Happening>
  void Print(const Happening& happening) {
    if (printer_) printer_->Print(happening);
  }

  std::unique_ptr<LiveJsonPrinter> printer_;
};

class LiveVerb {
 public:
  LiveVerb(const Options& options, std::vector<NamedCommand> commands)
      : options_(options),
        commands_(std::move(commands)),
        watch_(options.Has("--json")),
        client_(options.files[0], watch_, ClientOptions(options)) {
    screen_.endpoint = options.files[0];
    screen_.shows_board = options.Has("--board");
  }

  int Run() {
    const bool waits = options_.Has("--once") || !commands_.empty();
    if (waits && !AwaitState()) return 1;
    if (!SendCommands()) return 1;
    if (options_.Has("--once")) return PrintOnce();
    if (options_.Has("--json")) return WaitForInterrupt();
    return HasTerminal() ? DrawInPlace() : PrintSnapshots();
  }

 private:
  static LiveClientOptions ClientOptions(const Options& options) {
    LiveClientOptions live;
    live.name = "coppice live";
    live.token = TokenFromEnvironment();
    live.tree = options.Get("--tree");
    live.with_past = options.Has("--past");
    return live;
  }

  bool AwaitState() {
    const Duration end = Now() + kPatience;
    while (!interrupt_.came() && Now() < end) {
      const auto [has_state, changes] = watch_.Look([](const LiveScene& scene) {
        return std::make_pair(scene.connection.is_live && scene.run.state() != nullptr,
                              scene.changes);
      });
      if (has_state) return true;
      watch_.Wait(changes, kLookPeriod);
    }
    const std::string problem =
        watch_.Look([](const LiveScene& scene) { return scene.connection.problem; });
    std::cerr << Plain(problem.empty() ? "no answer from " + options_.files[0] : problem) << "\n";
    return false;
  }

  bool SendCommands() {
    bool all_done = true;
    for (const NamedCommand& named : commands_) {
      const LiveReply reply =
          named.unhooked.empty() ? Ask(named.command) : RemoveForeign(named.unhooked);
      const std::string& text = reply ? reply->remark : reply.problem();
      if (!text.empty()) std::cerr << named.option << ": " << Plain(text) << "\n";
      all_done = all_done && reply;
    }
    return all_done;
  }

  LiveReply RemoveForeign(const std::string& path) {
    LiveReply reply = Problem{"no other client has left anything there"};
    for (const ForeignHook& foreign :
         watch_.Look([](const LiveScene& scene) { return scene.foreign_hooks; })) {
      if (foreign.hook.path != path) continue;
      LiveCommand command = MakeCommand(Kind::kRemoveHook);
      command.id = foreign.id;
      reply = Ask(command);
      if (!reply) break;
    }
    return reply;
  }

  LiveReply Ask(const LiveCommand& command) {
    auto promise = std::make_shared<std::promise<LiveReply>>();
    std::future<LiveReply> reply = promise->get_future();
    client_.Send(command, [promise](const LiveReply& came) { promise->set_value(came); });
    if (reply.wait_for(kPatience) == std::future_status::ready) return reply.get();
    return Problem{"the robot does not answer"};
  }

  std::vector<std::string> Draw() const {
    return watch_.Look([this](const LiveScene& scene) { return DrawScene(scene, screen_); });
  }
  std::uint64_t changes() const {
    return watch_.Look([](const LiveScene& scene) { return scene.changes; });
  }

  void Print() const {
    for (const std::string& line : Draw()) std::cout << line << "\n";
    std::cout << std::flush;
  }

  // What came before this client was there may still be on its way.
  int PrintOnce() {
    const Duration end = Now() + 10 * kQuiet;
    while (Now() < end && watch_.Wait(changes(), kQuiet)) continue;
    Print();
    return 0;
  }

  int WaitForInterrupt() {
    while (!interrupt_.came() && std::cout) watch_.Wait(changes(), kLookPeriod);
    return 0;
  }

  int PrintSnapshots() {
    std::uint64_t printed = 0;
    while (!interrupt_.came() && std::cout) {
      if (!watch_.Wait(printed, kLookPeriod)) continue;
      printed = changes();
      Print();
      std::cout << "\n";
    }
    return 0;
  }

  int DrawInPlace() {
    LiveTerminal terminal;
    screen_.has_colours = true;
    std::uint64_t drawn = UINT64_MAX;
    std::size_t rows = 0;
    Duration next = Now();
    while (!interrupt_.came()) {
      for (char key = terminal.Key(); key != 0; key = terminal.Key()) {
        if (key == 'q') return 0;
        Press(key);
      }
      const LiveTerminal::Size size = terminal.size();
      const std::uint64_t now = changes();
      if (Now() >= next && (now != drawn || size.rows != rows)) {
        screen_.rows = rows = size.rows;
        screen_.columns = size.columns;
        terminal.Draw(Draw());
        drawn = now;
        next = Now() + kLookPeriod;
      }
      watch_.Wait(drawn, kLookPeriod);
      if (Now() < next) watch_.Wait(changes(), next - Now());
    }
    return 0;
  }

  void Press(char key) {
    const bool stands = watch_.Look([](const LiveScene& scene) { return !scene.stop.empty(); });
    if (key == ' ') return SendKey(stands ? Kind::kContinue : Kind::kPause);
    if (key == 'n') return SendKey(Kind::kStepNode);
    if (key == 't') return SendKey(Kind::kStepTick);
  }

  void SendKey(Kind kind) {
    client_.Send(MakeCommand(kind), [this](const LiveReply& reply) {
      if (!reply) watch_.Say(reply.problem());
    });
  }

  const Options& options_;
  const std::vector<NamedCommand> commands_;
  const Interrupt interrupt_;
  ScreenOptions screen_;
  Watch watch_;
  LiveClient client_;  // last: calls the others
};

}  // namespace

const Command& LiveVerbCommand() {
  static const Command command{
      "coppice live",
      "watch and debug a robot",
      {"HOST:PORT", 1, 1},
      R"(Shows what a robot does: its tree with statuses, the running path and what nodes say, until
Ctrl+C. In a terminal: space pauses and continues, n steps a node, t a tick, q ends.
What the options from --pause on hold is let go when this program ends. PATH is that of
`coppice replay`: patrol/DriveTo::7; patrol/DriveTo is every DriveTo there.
A robot that asks for a token finds it in COPPICE_LIVE_TOKEN.)",
      {CommandOption::Text("--tree", "NAME", "of several trees, by name or number"),
       CommandOption::Flag("--board", "also the blackboard"),
       CommandOption::Flag("--once", "prints how things stand and ends"),
       CommandOption::Flag("--json", "one JSON object per line for all that happens"),
       CommandOption::Flag("--past", "from the beginning, with --json"),
       CommandOption::Flag("--pause", "stops before the next tick"),
       CommandOption::Flag("--step", "does one tick"),
       CommandOption::Flag("--step-node", "does one node"),
       CommandOption::Flag("--continue", "lets it go on"),
       CommandOption::Text("--break", "PATH", "stops before a node"),
       CommandOption::Text("--if", "SCRIPT", "the --break before it only if the script is true"),
       CommandOption::Text("--inject", "PATH=STATUS[xN]",
                           "forces a result on a node, N times or always"),
       CommandOption::Text("--delay", "PATH=MILLISECONDS",
                           "the node is RUNNING for so long before it begins"),
       CommandOption::Text("--set", "[SUBTREE/]KEY=VALUE", "writes a value"),
       CommandOption::Text("--unhook", "PATH",
                           "removes what another client of the Groot2 protocol has left there")}};
  return command;
}

int RunLive(const Arguments& arguments) {
  const Options options = ParseOptions(LiveVerbCommand(), arguments);
  if (options.exit) return *options.exit;
  Expected<std::vector<NamedCommand>> commands = ReadCommands(options);
  if (!commands) return RefuseOptions(LiveVerbCommand(), commands.problem());
  try {
    return LiveVerb(options, *std::move(commands)).Run();
  } catch (const std::invalid_argument& error) {  // no such address, no such token
    std::cerr << error.what() << "\n";
    return 2;
  }
}

}  // namespace coppice
