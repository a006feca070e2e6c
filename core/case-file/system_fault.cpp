#include "case-file/system_fault.h"

#include <cerrno>
#include <cstring>

namespace ravnoves {

Message system_fault(int error) {
    struct Fault {
        int error;
        Text text;
    };
    static constexpr Fault faults[] = {
        {ENOENT, CORE_TEXT("core", "No such file or directory")},
        {EACCES, CORE_TEXT("core", "Permission denied")},
        {EPERM, CORE_TEXT("core", "Operation not permitted")},
        {ENOSPC, CORE_TEXT("core", "No space left on device")},
        {EDQUOT, CORE_TEXT("core", "Disk quota exceeded")},
        {EROFS, CORE_TEXT("core", "Read-only file system")},
        {EISDIR, CORE_TEXT("core", "Is a directory")},
        {ENOTDIR, CORE_TEXT("core", "Not a directory")},
        {ENAMETOOLONG, CORE_TEXT("core", "File name too long")},
        {EFBIG, CORE_TEXT("core", "File too large")},
        {EBUSY, CORE_TEXT("core", "Device or resource busy")},
        {ELOOP, CORE_TEXT("core", "Too many levels of symbolic links")},
        {EMFILE, CORE_TEXT("core", "Too many open files")},
        {EIO, CORE_TEXT("core", "Input/output error")},
    };
    for (const Fault& fault : faults) {
        if (fault.error == error) {
            return fault.text;
        }
    }
    return std::strerror(error);
}

}  // namespace ravnoves
