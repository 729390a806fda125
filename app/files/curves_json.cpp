#include "files/curves_json.h"

#include "discontinuity/curve.h"

namespace penumbra {

nlohmann::ordered_json curves_json(const Look &look) {
    using Json = nlohmann::ordered_json;
    const auto known = [](int i) { return i < 0 ? Json() : Json(i); };
    Json kinds = Json::array(), orders = Json::array();
    for (std::size_t k = 0; k < look.curve_filter.kinds.size(); ++k)
        if (look.curve_filter.kinds[k])
            kinds.push_back(name(static_cast<CurveKind>(k)));
    for (std::size_t k = 0; k < look.curve_filter.orders.size(); ++k)
        if (look.curve_filter.orders[k])
            orders.push_back(k);
    return {{"kinds", kinds},
            {"orders", orders},
            {"source", known(look.curve_filter.source)},
            {"shown", known(look.spotlight.curve)}};
}

} // namespace penumbra
