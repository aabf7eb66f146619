// Without the live socket (-DCOPPICE_LIVE=OFF).
#include <stdexcept>

#include "bt_core/cli/live/live_view.h"

namespace coppice {

class LivePublisher {};

LiveView::LiveView(EventStream&, const Options& options, std::function<void(const HistoryNote&)>) {
  if (!WantsLiveView(options)) return;
  throw std::runtime_error("this coppice was built without the live view");
}

LiveView::~LiveView() = default;

}  // namespace coppice
