// SPDX-License-Identifier: MIT
#include "view.h"

using namespace lumi;
using namespace lumi::detail::c;

#ifdef LUMI_C_DRAWS_SURFACES
lumi_error lumi_set_state(lumi_view* view, uint32_t state, uint16_t r_q12, uint16_t g_q12, uint16_t b_q12)
{
    return code(view == nullptr ? ViewError::no_field : view->set_state(state, StateWeight{r_q12, g_q12, b_q12}));
}
#endif
