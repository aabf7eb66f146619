// Answers the requests of the extension (docs/live.md): JSON in, JSON out. Knows no sockets.
#ifndef COPPICE_BT_CORE_LIVE_SERVER_EXTENSION_SERVICE_H_
#define COPPICE_BT_CORE_LIVE_SERVER_EXTENSION_SERVICE_H_

#include <string>
#include <string_view>

#include "bt_core/live/pictures/picture_set.h"
#include "bt_core/live/server/live_sessions.h"

namespace coppice {

inline constexpr int kExtensionVersion = 1;

class ExtensionService {
 public:
  /// `has_pictures`: there are some for those who ask for them.
  ExtensionService(const LiveTrees& trees, LiveSessions& sessions, Duration deadline,
                   bool has_pictures = false)
      : trees_(trees), sessions_(sessions), deadline_(deadline), has_pictures_(has_pictures) {}

  struct Answer {
    std::string json;
    bool failed = false;
  };
  /// `may_control`: the one who sends this request has the role for it. `now`: in real time. Never
  /// throws.
  Answer Serve(ClientId client, bool may_control, std::string_view request, Duration now);

  // Notices.
  std::string Describe(std::uint32_t tree, const DebugEvent& event) const;
  std::string DescribeTrees() const;
  std::string DescribeRelease() const;
  static std::string Describe(const LivePicture& picture);

 private:
  const LiveTrees& trees_;
  LiveSessions& sessions_;
  const Duration deadline_;
  const bool has_pictures_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_SERVER_EXTENSION_SERVICE_H_
