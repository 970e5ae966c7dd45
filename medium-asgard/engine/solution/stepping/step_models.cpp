#include "stepping/step_models.h"

namespace solution {

void StepModels::begin() {
    forget();
    integration_.begin();
}

void StepModels::forget() {
    integration_.dropMethod();
    current_ = nullptr;
}

void StepModels::take(StepModel& model, const char* name, const char* method, const char* why) {
    current_ = &model;
    context_.counts.model = name;
    context_.counts.method = method;
    context_.counts.why = why;
}

// A component that moved before keeps the name of its model.
void StepModels::takeRest() {
    if (context_.counts.model.empty())
        take(rest_, "closed-form", "exact", "at rest, until something happens");
    else
        current_ = &rest_;
}

void StepModels::decide(bool isPlain) {
    const bool ladder = context_.options.method == "auto";
    const bool hasStates = !context_.equations().states().empty();
    if ((ladder || !hasStates) && (isPlain || closedForm_.applies()))
        take(closedForm_, "closed-form", "exact", "polynomials in time");
    else if (!hasStates)
        take(values_, "closed-form", "evaluation", "held by expressions");
    else if (ladder && linear_.applies())
        take(linear_, "linear", "exponential",
             "linear, with constant coefficients: exact at the ends of its pieces");
    else if (ladder && rest_.applies())
        takeRest();
    else
        current_ = &integration_;
}

void StepModels::next() {
    if (context_.equations().states().empty())
        current_ = &values_;
    else
        current_ = &integration_;
}

} // namespace solution
