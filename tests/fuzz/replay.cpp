// Stands in for libFuzzer: gives a target each seed as it is, then damaged copies of it, the same
// in every run.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

using Bytes = std::string;

void give(const Bytes& bytes) {
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
}

/// One to eight changes: a bit, a byte that readers look for, a piece gone, doubled or from
/// another.
Bytes damaged(Bytes bytes, const Bytes& other, std::mt19937& random) {
    const auto below = [&](std::size_t end) { return end == 0 ? 0 : random() % end; };
    constexpr char telling[] = "\0\n\r\t\",:;{}[]+-.eE0129 ?\x1b\x80\xc3\xff";
    for (auto changes = 1 + below(8); changes > 0; --changes) {
        const std::size_t at = below(bytes.size() + 1);
        const std::size_t length = std::min(bytes.size() - at, 1 + below(40));
        switch (below(5)) {
            case 0:
                if (at < bytes.size()) {
                    bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(8)));
                }
                break;
            case 1:
                bytes.insert(at, 1, telling[below(sizeof telling - 1)]);
                break;
            case 2:
                bytes.erase(at, length);
                break;
            case 3:
                bytes.insert(at, bytes.substr(at, length));
                break;
            default:
                bytes.insert(at, other.substr(below(other.size() + 1), length));
        }
    }
    return bytes;
}

std::vector<Bytes> read_seeds(const std::vector<std::filesystem::path>& folders) {
    std::vector<std::filesystem::path> paths;
    for (const auto& folder : folders) {
        for (const auto& entry : std::filesystem::directory_iterator(folder)) {
            if (entry.is_regular_file()) {
                paths.push_back(entry.path());
            }
        }
    }
    std::sort(paths.begin(), paths.end());
    std::vector<Bytes> seeds;
    for (const auto& path : paths) {
        std::ifstream file(path, std::ios::binary);
        seeds.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
    }
    return seeds;
}

}  // namespace

int main(int count, char** arguments) {
    std::vector<std::filesystem::path> folders;
    int copies = 0;
    for (int k = 1; k < count; ++k) {
        if (std::string(arguments[k]) == "--copies" && k + 1 < count) {
            copies = std::atoi(arguments[++k]);
        } else {
            folders.emplace_back(arguments[k]);
        }
    }
    const std::vector<Bytes> seeds = read_seeds(folders);
    if (seeds.empty()) {
        std::fprintf(stderr, "no seeds in the folders given\n");
        return 2;
    }
    std::mt19937 random(2026);
    for (const Bytes& seed : seeds) {
        give(seed);
        for (int copy = 0; copy < copies; ++copy) {
            give(damaged(seed, seeds[random() % seeds.size()], random));
        }
    }
    std::printf("%zu seeds, %d damaged copies of each\n", seeds.size(), copies);
}
