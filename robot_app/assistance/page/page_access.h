// Who may see the supervisor page, and who may drive: tokens, links that work once, sessions.
//
// A link of a message bears a token that works once and ends with its request; whoever comes with
// it gets a session, which the browser keeps in a cookie. The tokens of the configuration may be
// used again and again. Of what was given out only hashes (BLAKE2b) are kept. Time is handed in.
// Any thread.
#ifndef COPPICE_ROBOT_APP_ASSISTANCE_PAGE_PAGE_ACCESS_H_
#define COPPICE_ROBOT_APP_ASSISTANCE_PAGE_PAGE_ACCESS_H_

#include <cstdint>
#include <deque>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "bt_core/base/clock.h"
#include "bt_core/base/outcome.h"

namespace coppice::robot::assistance {

enum class PageRole : std::uint8_t { kViewer, kOperator };

/// What somebody is let in as.
struct PagePass {
  PageRole role = PageRole::kViewer;
  std::string name;           ///< of the person; "operator" or "viewer" with a token for several
  std::uint32_t request = 0;  ///< the request whose link brought them; 0: none
  Time until{};
};

class PageAccess {
 public:
  static constexpr Duration kLinkLifetime = std::chrono::hours(24);
  static constexpr Duration kSessionLifetime = std::chrono::hours(8);
  /// Then the one that ends first ends now; one of a viewer as long as there is one, so that who
  /// may only watch does not take the wheel out of an operator's hand.
  static constexpr std::size_t kMostSessions = 64;
  /// Wrong tokens from one address within a minute; then more of them are not looked at until it is
  /// over. A right one is, so nobody can be kept out by the mistakes of others.
  static constexpr std::size_t kMostFailures = 20;
  static constexpr std::size_t kMostKeptFailures = 1000;  ///< of all addresses

  /// Tokens that can be used again; empty: there is none.
  explicit PageAccess(const std::string& operator_token = {}, const std::string& viewer_token = {});

  /// A token for one person and one request.
  std::string MakeLinkToken(const std::string& name, std::uint32_t request, Time now);

  struct Entry {
    std::string session;  ///< a secret
    PagePass pass;
  };
  /// `address`: from where; any text that tells callers apart.
  Expected<Entry> LogIn(std::string_view token, const std::string& address, Time now);

  /// Nothing if there is no such session (any more).
  std::optional<PagePass> Find(std::string_view session, Time now) const;
  void LogOut(std::string_view session);

  /// The links of a closed request end.
  void EndLinks(std::uint32_t request);

  /// By hash; what outlives the program.
  using Passes = std::map<std::string, PagePass>;
  struct State {
    Passes links;
    Passes sessions;
  };
  State state() const;
  void Restore(State state);
  /// Grows with every change of the state.
  std::uint64_t version() const;

 private:
  struct Failure {
    Time when{};
    std::string address;
  };

  std::optional<PagePass> Redeem(const std::string& hash, Time now);
  std::string AddSession(PagePass& pass, Time now);
  Problem Refuse(const std::string& address, Time now);

  const std::string operator_hash_;
  const std::string viewer_hash_;
  mutable std::mutex mutex_;  // for the rest
  State state_;
  std::deque<Failure> failures_;
  std::uint64_t version_ = 0;
};

}  // namespace coppice::robot::assistance

#endif  // COPPICE_ROBOT_APP_ASSISTANCE_PAGE_PAGE_ACCESS_H_
