// Texts of messages, made fit for protocols in which line ends and control characters mean
// something.
#ifndef COPPICE_ROBOT_APP_ASSISTANCE_CHANNELS_MESSAGE_TEXT_H_
#define COPPICE_ROBOT_APP_ASSISTANCE_CHANNELS_MESSAGE_TEXT_H_

#include <string>
#include <string_view>

namespace coppice::robot::assistance {

inline constexpr std::size_t kMostMessageBytes = 3500;  ///< Telegram takes 4096 characters

/// At most kMostMessageBytes bytes of valid UTF-8 without control characters but "\n"; what is
/// invalid becomes U+FFFD.
std::string MessageText(std::string_view text);

/// The same in one line, at most 200 bytes: ends of lines become blanks.
std::string OneLine(std::string_view text);

/// A value for a header of e-mail (RFC 5322): one line, and an encoded word (RFC 2047) if it is not
/// ASCII.
std::string MailHeader(std::string_view text);

/// An address for an envelope of e-mail, without angle brackets; empty if it is none that can be
/// handed on safely.
std::string MailAddress(std::string_view text);

/// The body for channels that know only text: text, and the link on a line of its own.
std::string WithLink(const std::string& text, const std::string& link);

}  // namespace coppice::robot::assistance

#endif  // COPPICE_ROBOT_APP_ASSISTANCE_CHANNELS_MESSAGE_TEXT_H_
