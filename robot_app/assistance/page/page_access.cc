#include "robot_app/assistance/page/page_access.h"

#include <sodium.h>

#include <algorithm>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace coppice::robot::assistance {
namespace {

constexpr std::size_t kTokenBytes = 24;
constexpr std::size_t kMostTokenLength = 512;

std::string Hex(const unsigned char* bytes, std::size_t size) {
  std::string text(2 * size + 1, '\0');
  sodium_bin2hex(text.data(), text.size(), bytes, size);
  text.pop_back();
  return text;
}

std::string NewSecret() {
  unsigned char bytes[kTokenBytes];
  randombytes_buf(bytes, sizeof(bytes));
  return Hex(bytes, sizeof(bytes));
}

// Texts are compared by their hashes, so the time that it takes tells nothing about them.
std::string Hash(std::string_view secret) {
  unsigned char hash[32];
  crypto_generichash(hash, sizeof(hash), reinterpret_cast<const unsigned char*>(secret.data()),
                     secret.size(), nullptr, 0);
  return Hex(hash, sizeof(hash));
}

std::string HashIfAny(const std::string& token) {
  if (sodium_init() < 0) throw std::runtime_error("libsodium cannot be used");
  return token.empty() ? "" : Hash(token);
}

void DropOld(PageAccess::Passes& passes, Time now) {
  for (auto it = passes.begin(); it != passes.end();) {
    it = it->second.until <= now ? passes.erase(it) : std::next(it);
  }
}

}  // namespace

PageAccess::PageAccess(const std::string& operator_token, const std::string& viewer_token)
    : operator_hash_(HashIfAny(operator_token)), viewer_hash_(HashIfAny(viewer_token)) {}

std::string PageAccess::MakeLinkToken(const std::string& name, std::uint32_t request, Time now) {
  std::string token = NewSecret();
  const std::lock_guard<std::mutex> lock(mutex_);
  DropOld(state_.links, now);
  state_.links[Hash(token)] = {PageRole::kOperator, name, request, now + kLinkLifetime};
  ++version_;
  return token;
}

Expected<PageAccess::Entry> PageAccess::LogIn(std::string_view token, const std::string& address,
                                              Time now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const std::optional<PagePass> pass = Redeem(Hash(token.substr(0, kMostTokenLength)), now);
  if (!pass) return Refuse(address, now);
  Entry entry;
  entry.pass = *pass;
  entry.session = AddSession(entry.pass, now);
  return entry;
}

// What the token of that hash stands for; a link's is used up.
std::optional<PagePass> PageAccess::Redeem(const std::string& hash, Time now) {
  const auto link = state_.links.find(hash);
  if (link != state_.links.end() && link->second.until > now) {
    const PagePass pass = link->second;
    state_.links.erase(link);
    return pass;
  }
  if (hash == operator_hash_) return PagePass{PageRole::kOperator, "operator", 0, now};
  if (hash == viewer_hash_) return PagePass{PageRole::kViewer, "viewer", 0, now};
  return std::nullopt;
}

// Why a wrong token is refused, for people; counts it.
Problem PageAccess::Refuse(const std::string& address, Time now) {
  while (!failures_.empty() && failures_.front().when + std::chrono::minutes(1) <= now) {
    failures_.pop_front();
  }
  const auto count = std::count_if(failures_.begin(), failures_.end(),
                                   [&](const Failure& one) { return one.address == address; });
  if (static_cast<std::size_t>(count) >= kMostFailures) {
    return {"Too many wrong tokens were tried. Wait a minute."};
  }
  if (failures_.size() >= kMostKeptFailures) failures_.pop_front();
  failures_.push_back({now, address});
  return {"This token is not valid. A link of a message works once, until its request is closed."};
}

std::optional<PagePass> PageAccess::Find(std::string_view session, Time now) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = state_.sessions.find(Hash(session.substr(0, kMostTokenLength)));
  if (found == state_.sessions.end() || found->second.until <= now) return std::nullopt;
  return found->second;
}

void PageAccess::LogOut(std::string_view session) {
  const std::lock_guard<std::mutex> lock(mutex_);
  version_ += state_.sessions.erase(Hash(session.substr(0, kMostTokenLength)));
}

void PageAccess::EndLinks(std::uint32_t request) {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (auto it = state_.links.begin(); it != state_.links.end();) {
    const bool ends = it->second.request == request;
    version_ += ends;
    it = ends ? state_.links.erase(it) : std::next(it);
  }
}

PageAccess::State PageAccess::state() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return state_;
}

void PageAccess::Restore(State state) {
  const std::lock_guard<std::mutex> lock(mutex_);
  state_ = std::move(state);
}

std::uint64_t PageAccess::version() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return version_;
}

std::string PageAccess::AddSession(PagePass& pass, Time now) {
  Passes& sessions = state_.sessions;
  DropOld(sessions, now);
  if (sessions.size() >= kMostSessions) {
    sessions.erase(
        std::min_element(sessions.begin(), sessions.end(), [](const auto& a, const auto& b) {
          return std::tie(a.second.role, a.second.until) < std::tie(b.second.role, b.second.until);
        }));
  }
  pass.until = now + kSessionLifetime;
  std::string session = NewSecret();
  sessions[Hash(session)] = pass;
  ++version_;
  return session;
}

}  // namespace coppice::robot::assistance
