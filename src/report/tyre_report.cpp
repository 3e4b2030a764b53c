#include "report/tyre_report.h"

#include "report/html.h"

namespace tread {

std::string figurePage(const std::string& title, const std::string& intro, const std::vector<FigureGroup>& groups) {
    HtmlPage page(title);
    page.answer(intro);
    for (const FigureGroup& group : groups) {
        page.section(group.title);
        if (!group.text.empty()) page.text(group.text);
        page.figures(group.charts);
    }
    return page.finish();
}

}  // namespace tread
