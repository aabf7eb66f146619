#include <cstdlib>
#include <memory>
#include <string>

#include "bt_core/live/server/live_desk.h"
#include "bt_core/nodes/leaf.h"
#include "tests/fuzz/fuzz_targets.h"

namespace coppice::fuzz {
namespace {

constexpr char kTree[] = R"(
<root BTCPP_format="4" main_tree_to_execute="Main"><BehaviorTree ID="Main">
  <ReactiveSequence name="top">
    <Script code="n := 1"/>
    <SubTree ID="Inner" name="inner" word="{word}" number="5"/>
    <Sleep name="s" msec="{n}"/>
  </ReactiveSequence>
</BehaviorTree>
<BehaviorTree ID="Inner"><AlwaysSuccess name="a"/></BehaviorTree></root>)";

std::shared_ptr<const Program> CompileTree() {
  Diagnostics diagnostics;
  auto project = Project::FromText(kTree, "", diagnostics);
  auto program = Compile(std::make_shared<const Project>(*std::move(project)),
                         std::make_shared<Registry>(), diagnostics);
  if (!program) std::abort();
  return program;
}

// Reads along: every answer must be one of the three forms.
class CheckingOutbox : public LiveOutbox {
 public:
  SendResult Reply(ClientId client, const groot2::Parts& parts) override {
    return Send(client, parts);
  }
  SendResult Send(ClientId, const groot2::Parts& parts) override {
    const bool is_error = parts.size() == 2 && parts[0] == "error" && !parts[1].empty();
    const bool is_reply = !parts.empty() && parts.size() <= 2 && parts[0].size() == 22;
    if (!is_error && !is_reply) std::abort();
    good += is_reply && parts[0][1] != 'C';
    good += is_reply && parts[0][1] == 'C' && parts[1].find("\"error\"") == std::string::npos;
    return static_cast<SendResult>(++sent % 64 == 0);  // now and then it is full
  }
  void Publish(const groot2::Parts& parts) override {
    if (parts.size() != 2 || parts[0].size() != 6) std::abort();
  }

  int good = 0;
  int sent = 0;
};

groot2::Parts MakeRequest(std::string_view line) {
  groot2::Parts parts;
  if (line.empty()) return parts;
  parts.push_back(groot2::MakeHeader(line[0], 7));
  if (line.size() > 1) parts.emplace_back(line.substr(1));
  if (line[0] == '!') parts[0] = line;  // a header of another length
  return parts;
}

}  // namespace

int FuzzLive(std::string_view bytes) {
  static const std::shared_ptr<const Program> program = CompileTree();
  constexpr Duration kDeadline = std::chrono::seconds(5);
  SimulatedClock clock;
  Executor executor(program, clock);
  executor.inbox()->set_ending(true);  // nothing may hold up the ticks below
  EventStream stream(executor, 64 << 10);
  const auto tree = std::make_shared<LiveTree>(stream, LiveTreeOptions(), [] {});
  stream.Add(*tree);
  stream.Flush();
  CheckingOutbox outbox;
  LiveDesk desk(outbox, kDeadline);
  Duration now = std::chrono::seconds(1);
  desk.Add(tree, now);
  // A line is a request: who asks and when, the type, its second part.
  while (!bytes.empty()) {
    const std::string_view line = bytes.substr(0, bytes.find('\n'));
    bytes.remove_prefix(std::min(line.size() + 1, bytes.size()));
    if (line.empty()) continue;
    const auto who = static_cast<unsigned char>(line[0]);
    if (who % 16 == 0) now += kDeadline;
    desk.Serve(ClientId(who % 4), who % 8 != 0, MakeRequest(line.substr(1)), now);
    executor.Tick();
    clock.Advance(std::chrono::milliseconds(1));
    desk.Attend(now);
  }
  stream.Remove(*tree);
  desk.Remove(*tree);
  return outbox.good;
}

}  // namespace coppice::fuzz
