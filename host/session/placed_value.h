// A value of a subdocument, and the bytes of the document that ask for it.
#pragma once

#include "document/value_use.h"
#include "text/edit.h"

namespace session {

struct PlacedValue {
    document::ValueUse use;
    text::Range range;
    bool isElement = true; // else a part of a formula
};

} // namespace session
