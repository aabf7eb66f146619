// Without the live socket (-DCOPPICE_LIVE=OFF).
#include <stdexcept>

#include "bt_core/cli/live/live_view.h"

namespace coppice {

class LivePublisher {};

LiveView::LiveView(EventStream&, const Options& options) {
  for (const std::vector<std::string>& names : {WithValue(), Flags()}) {
    for (const std::string& name : names) {
      if (!options.Has(name)) continue;
      throw std::runtime_error(name + ": this coppice was built without the live view");
    }
  }
}

LiveView::~LiveView() = default;

}  // namespace coppice
