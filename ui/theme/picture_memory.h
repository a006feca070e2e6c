#pragma once

namespace ravnoves {

/// Keeps memory that pictures of the window's size have left for the next ones. By itself the C
/// library returns it to the system, and a window that is resized asks for it anew at every step:
/// then each page of it is cleared before it is painted over. At most 64 MiB stay kept. To be
/// called before the application is made; where the library is another one it does nothing.
void keepPictureMemory();

}  // namespace ravnoves
