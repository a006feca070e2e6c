#pragma once

#include <map>
#include <string>

#include "case-file/message.h"

namespace ravnoves {

/// While one lives, it keeps what this thread's messages read in English: a result holds reasons as
/// English texts, and whoever shows them in another language asks what was said.
class SaidMessages {
  public:
    SaidMessages();
    ~SaidMessages();
    SaidMessages(const SaidMessages&) = delete;
    SaidMessages& operator=(const SaidMessages&) = delete;

    /// The message that reads so; a text that none reads like, verbatim.
    Message of(const std::string& english) const;

  private:
    friend class Message;
    void keep(const std::string& english, const Message& message);

    std::map<std::string, Message> messages_;
    SaidMessages* around_;
};

}  // namespace ravnoves
