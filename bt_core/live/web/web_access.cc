#include "bt_core/live/web/web_access.h"

#include <sodium.h>

#include <cstddef>

namespace coppice {
namespace {

std::string_view Trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

std::string_view TakeItem(std::string_view& list) {
  const std::size_t comma = list.find(',');
  const std::string_view item = list.substr(0, comma);
  list.remove_prefix(comma == std::string_view::npos ? list.size() : comma + 1);
  return Trimmed(item);
}

struct Offer {
  bool knows_protocol = false;
  std::string_view token;
};

Offer ReadOffer(std::string_view protocols) {
  constexpr std::string_view kPrefix = kWebTokenPrefix;
  Offer offer;
  while (!protocols.empty()) {
    const std::string_view item = TakeItem(protocols);
    if (item == kWebProtocol) offer.knows_protocol = true;
    if (item.substr(0, kPrefix.size()) == kPrefix) offer.token = item.substr(kPrefix.size());
  }
  return offer;
}

// Takes as long wherever the first difference is.
bool IsSame(std::string_view token, const std::string& expected) {
  return !expected.empty() && token.size() == expected.size() &&
         sodium_memcmp(token.data(), expected.data(), expected.size()) == 0;
}

// Without the port.
std::string_view NameOf(std::string_view host) {
  if (!host.empty() && host.front() == '[') return host.substr(0, host.find(']') + 1);
  return host.substr(0, host.find(':'));
}

bool IsNumber(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789.") == std::string_view::npos;
}

// Names that no name server is asked for.
bool IsThisComputer(std::string_view host) {
  const std::string_view name = NameOf(host);
  return name == "localhost" || name == "[::1]" || (name.substr(0, 4) == "127." && IsNumber(name));
}

}  // namespace

// "https" if something in between adds the encryption.
bool IsOwnPage(std::string_view origin, std::string_view host) {
  for (const std::string_view scheme : {"http://", "https://"}) {
    if (origin.substr(0, scheme.size()) == scheme) return origin.substr(scheme.size()) == host;
  }
  return false;
}

bool IsLocalName(std::string_view host) {
  constexpr std::string_view kLocal = ".local";
  const std::string_view name = NameOf(host);
  if (name.empty() || name.front() == '[' || IsNumber(name)) return !name.empty();
  const bool is_multicast =
      name.size() > kLocal.size() && name.substr(name.size() - kLocal.size()) == kLocal;
  return is_multicast || name.find('.') == std::string_view::npos;
}

Expected<WebRole> WebAccess::Judge(const WebVisitor& visitor) const {
  const Offer offer = ReadOffer(visitor.protocols);
  if (!offer.knows_protocol) {
    return Problem{std::string("the subprotocol ") + kWebProtocol + " must be asked for"};
  }
  if (!visitor.origin.empty() && !IsOwnPage(visitor.origin, visitor.host)) {
    return Problem{"this page is of another origin"};
  }
  if (tokens_.control.empty()) {
    if (IsThisComputer(visitor.host)) return WebRole::kControl;
    return Problem{"without a token only localhost is let in"};
  }
  if (IsSame(offer.token, tokens_.control)) return WebRole::kControl;
  if (IsSame(offer.token, tokens_.read)) return WebRole::kRead;
  return Problem{"a token is needed, or it is not the right one"};
}

}  // namespace coppice
