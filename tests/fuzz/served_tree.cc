#include "tests/fuzz/served_tree.h"

#include <cstdlib>

#include "bt_core/nodes/leaf.h"

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

constexpr Duration kDeadline = std::chrono::seconds(5);

std::shared_ptr<const Program> CompileTree() {
  Diagnostics diagnostics;
  auto project = Project::FromText(kTree, "", diagnostics);
  auto program = Compile(std::make_shared<const Project>(*std::move(project)),
                         std::make_shared<Registry>(), diagnostics);
  if (!program) std::abort();
  return program;
}

const std::shared_ptr<const Program>& TreeProgram() {
  static const std::shared_ptr<const Program> program = CompileTree();
  return program;
}

}  // namespace

SendResult CheckingOutbox::Send(ClientId, const groot2::Parts& parts) {
  const bool is_error = parts.size() == 2 && parts[0] == "error" && !parts[1].empty();
  const bool is_reply = !parts.empty() && parts.size() <= 2 && parts[0].size() == 22;
  if (!is_error && !is_reply) std::abort();
  good += is_reply && parts[0][1] != 'C';
  good += is_reply && parts[0][1] == 'C' && parts[1].find("\"error\"") == std::string::npos;
  return static_cast<SendResult>(++sent_ % 64 == 0);  // now and then it is full
}

void CheckingOutbox::Publish(const groot2::Parts& parts) {
  if (parts.size() != 2 || parts[0].size() != 6) std::abort();
}

ServedTree::ServedTree(LiveOutbox& outbox)
    : executor_(TreeProgram(), clock_),
      stream_(executor_, 64 << 10),
      tree_(std::make_shared<LiveTree>(stream_, LiveTreeOptions(), [] {})),
      desk_(outbox, kDeadline),
      now_(std::chrono::seconds(1)) {
  executor_.inbox()->set_ending(true);  // nothing may hold up the ticks below
  stream_.Add(*tree_);
  stream_.Flush();
  desk_.Add(tree_, now_);
}

ServedTree::~ServedTree() {
  stream_.Remove(*tree_);
  desk_.Remove(*tree_);
}

void ServedTree::Serve(ClientId client, bool may_control, const groot2::Parts& request) {
  desk_.Serve(client, may_control, request, now_);
  executor_.Tick();
  clock_.Advance(std::chrono::milliseconds(1));
  desk_.Attend(now_, now_);
}

void ServedTree::OutlastClients() { now_ += kDeadline; }

}  // namespace coppice::fuzz
