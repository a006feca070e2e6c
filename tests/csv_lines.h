#pragma once

#include <string>
#include <vector>

namespace ravnoves::test {

/// Reads CSV (RFC 4180): lines of fields, quotes taken off.
inline std::vector<std::vector<std::string>> csv_lines(const std::string& text) {
    std::vector<std::vector<std::string>> lines;
    std::vector<std::string> fields(1);
    bool quoted = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (quoted) {
            if (c == '"' && i + 1 < text.size() && text[i + 1] == '"') {
                fields.back() += '"';
                ++i;
            } else if (c == '"') {
                quoted = false;
            } else {
                fields.back() += c;
            }
        } else if (c == '"') {
            quoted = true;
        } else if (c == ',') {
            fields.emplace_back();
        } else if (c == '\n') {
            lines.push_back(fields);
            fields.assign(1, "");
        } else {
            fields.back() += c;
        }
    }
    return lines;
}

}  // namespace ravnoves::test
