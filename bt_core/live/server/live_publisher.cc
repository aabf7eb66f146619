#include "bt_core/live/server/live_publisher.h"

#include "bt_core/live/server/live_tree.h"

namespace coppice {

LivePublisher::LivePublisher(EventStream& stream, const LiveOptions& options)
    : LivePublisher(stream, std::make_unique<LiveServer>(options), nullptr, options) {}

LivePublisher::LivePublisher(EventStream& stream, LiveServer& server,
                             const LiveTreeOptions& options)
    : LivePublisher(stream, nullptr, &server, options) {}

LivePublisher::LivePublisher(EventStream& stream, std::unique_ptr<LiveServer> own,
                             LiveServer* other, const LiveTreeOptions& options)
    : own_server_(std::move(own)),
      server_(own_server_ ? *own_server_ : *other),
      stream_(stream),
      tree_(std::make_shared<LiveTree>(stream, options, [this] { server_.Wake(); })) {
  stream_.Add(*tree_);
  stream_.Flush();  // now the tree knows how it stands
  if (options.wait_for_client > Duration::zero()) {
    // A tree that may not be stopped now does not wait either.
    static_cast<void>(tree_->debugger().Pause(LiveTree::kWaitOwner));
  }
  server_.Add(tree_);
}

LivePublisher::~LivePublisher() {
  stream_.Remove(*tree_);
  tree_->debugger().ReleaseAll();
  server_.Remove(tree_);
}

Debugger& LivePublisher::debugger() { return tree_->debugger(); }

}  // namespace coppice
