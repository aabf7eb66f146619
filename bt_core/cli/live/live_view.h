// `coppice run --live`: the options of the live view, and the view.
#ifndef COPPICE_BT_CORE_CLI_LIVE_LIVE_VIEW_H_
#define COPPICE_BT_CORE_CLI_LIVE_LIVE_VIEW_H_

#include <memory>
#include <string>
#include <vector>

#include "bt_core/base/command_line.h"
#include "bt_core/engine/events/event_stream.h"

namespace coppice {

class LivePublisher;

class LiveView {
 public:
  static constexpr const char* kUsage =
      "  --live                    others may watch and debug it: coppice live, the editor, "
      "Groot2\n"
      "  --live-port N             where; 1667 without it, 0 takes a free one\n"
      "  --live-address A          not only on this computer; needs a token in COPPICE_LIVE_TOKEN\n"
      "  --live-read-only          they may watch, not control\n"
      "  --web                     also in a browser, with the editor\n"
      "  --web-port N              where; 8667 without it, 0 takes a free one\n"
      "  --web-folder FOLDER       where the files of the editor's page lie\n"
      "  --wait-for-client SECONDS how long the first tick waits for one that says continue";

  /// Options for ParseOptions.
  static std::vector<std::string> WithValue() {
    return {"--live-port", "--live-address", "--wait-for-client", "--web-port", "--web-folder"};
  }
  static std::vector<std::string> Flags() { return {"--live", "--live-read-only", "--web"}; }

  /// Opens the view if one of the options is given, and prints where it is. The stream must live
  /// longer. Throws std::exception with a text for people if that cannot be.
  LiveView(EventStream& stream, const Options& options);
  ~LiveView();
  LiveView(const LiveView&) = delete;
  LiveView& operator=(const LiveView&) = delete;

 private:
  std::unique_ptr<LivePublisher> publisher_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_CLI_LIVE_LIVE_VIEW_H_
