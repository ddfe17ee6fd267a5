# Makes generated/report/assets.hpp: what the program carries as strings, each the files of
# src/report/assets that follow its name.
set(page_script data theme clock colours layout field cells frame player selection charts controls
                save)
list(TRANSFORM page_script REPLACE "(.+)" "page/\\1.js")
list(JOIN page_script " " page_script)
set(sweep_script numbers points figure tables page)
list(TRANSFORM sweep_script REPLACE "(.+)" "sweep/\\1.js")
list(JOIN sweep_script " " sweep_script)
set(TT_ASSETS "")
foreach(pair "chart_script uPlot.iife.min.js" "chart_style uPlot.min.css" "chart_licence uPlot.LICENSE"
             "page_script ${page_script}" "page_style page.css"
             "figure_style style.gp" "page_head head.html" "player_markup player.html" "charts_markup charts.html"
             "sweep_script ${sweep_script}" "sweep_style sweep/style.css" "sweep_markup sweep/markup.html")
  separate_arguments(pair)
  list(POP_FRONT pair name)
  set(content "")
  foreach(file IN LISTS pair)
    set(path ${CMAKE_CURRENT_LIST_DIR}/assets/${file})
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${path})
    file(READ ${path} part)
    string(APPEND content "${part}")
  endforeach()
  string(APPEND TT_ASSETS "inline constexpr std::string_view ${name} = R\"asset(${content})asset\";\n\n")
endforeach()
configure_file(${CMAKE_CURRENT_LIST_DIR}/assets.hpp.in ${CMAKE_BINARY_DIR}/generated/report/assets.hpp @ONLY)
