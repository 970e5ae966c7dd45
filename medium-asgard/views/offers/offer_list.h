// The changes that are possible in place of one that is not, as buttons with the lines of the text
// as they would be.
#pragma once

#include "editing/value_edit.h"

#include <functional>
#include <string>
#include <vector>

class QVBoxLayout;

namespace views {

// In place of those that the column holds.
void showOffers(QVBoxLayout& column, const std::string& text,
                const std::vector<editing::Offer>& offers,
                const std::function<void(const text::Edits& edits)>& take);

} // namespace views
