#include "case-file/sha256.h"

#include <nettle/base16.h>
#include <nettle/sha2.h>

#include <algorithm>
#include <array>
#include <cstdint>

namespace ravnoves {

std::string sha256(std::string_view bytes) {
    sha256_ctx context;
    sha256_init(&context);
    sha256_update(&context, bytes.size(), reinterpret_cast<const std::uint8_t*>(bytes.data()));
    std::array<std::uint8_t, SHA256_DIGEST_SIZE> digest{};
    sha256_digest(&context, digest.size(), digest.data());
    std::string text(BASE16_ENCODE_LENGTH(digest.size()), '\0');
    base16_encode_update(text.data(), digest.size(), digest.data());
    return text;
}

bool is_other_sum(std::string_view kept, std::string_view now) {
    const auto small = [](char digit) {
        return digit >= 'A' && digit <= 'F' ? static_cast<char>(digit - 'A' + 'a') : digit;
    };
    return !kept.empty() && !std::equal(kept.begin(), kept.end(), now.begin(), now.end(),
                                        [&](char a, char b) { return small(a) == small(b); });
}

Message changed_note(const std::string& file) {
    return {Text::tr(
                "%1 has changed since this case was made: import it again to accept the change, or "
                "restore the old file."),
            file};
}

}  // namespace ravnoves
