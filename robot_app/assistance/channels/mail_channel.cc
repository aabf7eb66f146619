#include "robot_app/assistance/channels/mail_channel.h"

#include <ctime>
#include <string>

#include "robot_app/assistance/channels/message_text.h"
#include "robot_app/common/web/curl_handle.h"

namespace coppice::robot::assistance {
namespace {

constexpr std::chrono::seconds kTimeout{15};

// RFC 5322, whatever the language of the computer.
std::string DateNow() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  constexpr const char* kDays[] = {"Sun", "Mon", "Tue", "Wed", "Thu", "Fri", "Sat"};
  constexpr const char* kMonths[] = {"Jan", "Feb", "Mar", "Apr", "May", "Jun",
                                     "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};
  char clock[32];
  std::strftime(clock, sizeof(clock), "%Y %H:%M:%S +0000", &utc);
  return std::string(kDays[utc.tm_wday]) + ", " + std::to_string(utc.tm_mday) + " " +
         kMonths[utc.tm_mon] + " " + clock;
}

bool IsLocal(const std::string& url) {
  return url.find("://127.") != std::string::npos || url.find("://localhost") != std::string::npos;
}

// As the ends of lines in mail are.
std::string WithMailLines(const std::string& text) {
  std::string lines;
  for (const char c : text) lines += c == '\n' ? std::string("\r\n") : std::string(1, c);
  return lines;
}

// The parts of a message; they belong to one transfer.
class Mime {
 public:
  Mime(CurlHandle& curl, const std::string& text) : mime_(curl_mime_init(curl.get())) {
    curl_mimepart* const part = curl_mime_addpart(mime_);
    curl_mime_data(part, text.c_str(), text.size());
    curl_mime_type(part, "text/plain; charset=utf-8");
    curl_mime_encoder(part, "quoted-printable");
    curl.Set(CURLOPT_MIMEPOST, mime_);
  }
  ~Mime() { curl_mime_free(mime_); }
  Mime(const Mime&) = delete;
  Mime& operator=(const Mime&) = delete;

 private:
  curl_mime* const mime_;
};

}  // namespace

Outcome MailChannel::Send(const OutgoingMessage& message, const std::atomic<bool>& cancelled) {
  const std::string to = MailAddress(message.to);
  const std::string from = MailAddress(config_.from);
  if (to.empty()) return Problem{"\"" + OneLine(message.to) + "\" is no mail address"};
  if (from.empty()) return Problem{"\"" + OneLine(config_.from) + "\" is no mail address"};
  CurlHandle curl(config_.url, "smtp,smtps", kTimeout, cancelled);
  curl.Set(CURLOPT_MAIL_FROM, from.c_str());
  curl.AddRecipient(to);
  const bool needs_encryption = !config_.user.empty() && !IsLocal(config_.url);
  curl.Set(CURLOPT_USE_SSL, static_cast<long>(needs_encryption ? CURLUSESSL_ALL : CURLUSESSL_TRY));
  if (!config_.user.empty()) {
    curl.Set(CURLOPT_USERNAME, config_.user.c_str());
    curl.Set(CURLOPT_PASSWORD, config_.secret.c_str());
  }
  curl.AddHeader("Date: " + DateNow());
  curl.AddHeader("From: <" + from + ">");
  curl.AddHeader("To: <" + to + ">");
  curl.AddHeader("Subject: " + MailHeader(message.headline));
  curl.AddHeader("Message-ID: <" + message.id + from.substr(from.find('@')) + ">");
  curl.AddHeader("Auto-Submitted: auto-generated");
  const Mime mime(curl, WithMailLines(WithLink(MessageText(message.text), OneLine(message.link))));
  return curl.Perform();
}

}  // namespace coppice::robot::assistance
