#pragma once

#include "model/case_document.h"

namespace ravnoves {

class Documents;
struct OpenDocument;

/// What a document asks before it is saved, overwritten or closed, over the window of the others;
/// both outlive the dialogs.
DocumentDialogs savingDialogs(Documents& documents, OpenDocument& document);

}  // namespace ravnoves
