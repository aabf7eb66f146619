#include "robot_app/assistance/page/running_path.h"

namespace coppice::robot::assistance {
namespace {

// The last part of the path, without the number that a node without a name bears.
std::string NameOf(const DescribedNode& node) {
  const std::size_t slash = node.path.rfind('/');
  const std::string name = slash == std::string::npos ? node.path : node.path.substr(slash + 1);
  return name.substr(0, name.find("::"));
}

LiveClientOptions Options() {
  LiveClientOptions options;
  options.name = "supervisor page";
  options.token = TokenFromEnvironment();
  options.with_past = false;
  return options;
}

}  // namespace

std::vector<std::string> RunningPath(const TreeDescription& tree,
                                     const std::vector<Status>& statuses) {
  std::vector<std::string> path;
  NodeIndex deepest{0};  // nodes are in preorder
  for (NodeIndex i{0}; i < tree.nodes.size() && i < statuses.size(); ++i) {
    const DescribedNode& node = tree.nodes[i];
    const bool continues = path.empty() ? i == 0 : node.parent == deepest && i != 0;
    if (!continues || statuses[i] != Status::kRunning) continue;
    deepest = i;
    const std::string name = NameOf(node);
    if (path.empty() || path.back() != name) path.push_back(name);  // a SubTree and its root
  }
  return path;
}

RunningPathFollower::RunningPathFollower(const std::string& endpoint)
    : client_(std::make_unique<LiveClient>(endpoint, *this, Options())) {}

RunningPathFollower::~RunningPathFollower() = default;  // the client, being last, ends first

RunningPathFollower::View RunningPathFollower::Now() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!is_live_ || !run_.state()) return {};
  return {true, RunningPath(run_.tree(), run_.state()->statuses())};
}

void RunningPathFollower::OnConnection(const LiveConnection& connection) {
  const std::lock_guard<std::mutex> lock(mutex_);
  is_live_ = connection.is_live;
}

void RunningPathFollower::OnTree(const TreeDescription& tree) {
  const std::lock_guard<std::mutex> lock(mutex_);
  run_.Set(tree);
}

void RunningPathFollower::OnState(const HistoryState& state) {
  const std::lock_guard<std::mutex> lock(mutex_);
  run_.Set(state);
}

void RunningPathFollower::OnTick(const TickEvents& events) {
  const std::lock_guard<std::mutex> lock(mutex_);
  run_.Apply(events);
}

}  // namespace coppice::robot::assistance
