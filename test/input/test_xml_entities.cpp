// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Entities of XML: shapes and attributes that stand in them are read, and none takes any time or memory.

#include "../support/curve_text.h"

namespace test_xml_entities {
namespace {

using namespace bounding_arcs_test;

// A drawing with declarations of its own.
std::string with(const std::string& declarations, const std::string& content) {
  return "<!DOCTYPE svg [" + declarations + "]>\n" + svg(content);
}

Curve_file read_all(const std::string& text) { return Curve_file::from_text(text, "shape.svg", "shape"); }

std::vector<std::string> names(const std::string& text) {
  std::vector<std::string> result;
  for (const Curve_record& record : read_all(text).curves) result.push_back(record.name);
  return result;
}

using Names = std::vector<std::string>;

const std::string LINE = "<!ENTITY line '<line x2=\"1\"/>'>";

TEST(XmlEntities, MayHoldElements) {
  EXPECT_EQ(names(with(LINE, "<circle r='1'/>&line;")), (Names{"circle1", "line1"}));
  EXPECT_EQ(names(with(LINE + "<!ENTITY both '<g>&line;</g>&line;'>", "&both;&both;")).size(), 4u);
  EXPECT_EQ(names(with("<!ENTITY line '&#60;line x2=&#x22;1\"/>'>", "&line;")), (Names{"line1"}));
  EXPECT_EQ(names("<?xml version='1.0'?><!-- x --> <!DOCTYPE svg PUBLIC '[' \">\" [" + LINE + "] >" + svg("&line;")),
            (Names{"line1"}));
}

TEST(XmlEntities, MayStandInAttributes) {
  const auto data = [](const std::string& declarations, const std::string& value) {
    return polygon(read_all(with(declarations, "<path d=" + value + "/>")).curves[0]);
  };
  EXPECT_EQ(data("<!ENTITY a 'h1'><!ENTITY b '&a;v1'>", "'M0 0&b;'"), (Points{{0, 0}, {1, 0}, {1, 1}}));
  EXPECT_EQ(data("<!ENTITY a 'M0 0h1'>", "\"&a;\" a='&#38;'"), (Points{{0, 0}, {1, 0}}));
  EXPECT_EQ(names(with("<!ENTITY a 'x=\"&apos;1&#34;'>", "<line id='&a;' x2='1'/>")), (Names{"x=\"'1\""}));
  EXPECT_EQ(names(with("<!ENTITY a '&#60;&#38;#233;>'>", "<line id='&a;' x2='1'/>")), (Names{"<\xC3\xA9>"}));
  EXPECT_EQ(names("<!DOCTYPE svg [<!ENTITY u 'http://www.w3.org/2000/svg'><!ENTITY o 'http://other'>]>"
                  "<a:svg xmlns:a='&u;' xmlns='&o;'><a:line x2='1'/><line x2='2'/></a:svg>"),
            (Names{"line1"}));
}

TEST(XmlEntities, AreTakenByTheirFirstDeclaration) {
  const std::string other = "<!ENTITY line '<rect width=\"1\" height=\"1\"/>'>";
  EXPECT_EQ(names(with(LINE + other, "&line;")), (Names{"line1"}));
  EXPECT_EQ(names(with("<!--" + other + "--><?x " + other + "?><!ENTITY % line 'x'>" + LINE, "&line;")),
            (Names{"line1"}));
  EXPECT_EQ(names(with("<!ELEMENT x ANY><!ATTLIST x y CDATA '>'><!NOTATION z SYSTEM ']'>%p;" + LINE, "&line;")),
            (Names{"line1"}));
}

TEST(XmlEntities, CountOnlyWhereTheyAreRead) {
  const std::string seen = "<circle r='1' id='c'/>";
  for (const char* unseen : {"<!-- &line; -->", "<![CDATA[&line;]]>", "<?x &line; ?>", "<title>&amp;line;</title>",
                             "<title a='>'>&#38;line;</title>"})
    EXPECT_EQ(names(with(LINE, seen + unseen)), (Names{"c"})) << unseen;
  EXPECT_EQ(names(with("<!ENTITY c '<!-- &line; --><![CDATA[&line;]]>'>" + LINE, seen + "&c;")), (Names{"c"}));
  EXPECT_EQ(names(svg(seen + "&line;")), (Names{"c"}));
}

TEST(XmlEntities, ThatAreNotInTheFileHaveANote) {
  const auto notes = [](const std::string& declarations, const std::string& content) {
    return Curve_file::text_of(read_all(with(declarations, "<line x2='1'/>" + content)).notes);
  };
  EXPECT_EQ(notes("<!ENTITY e SYSTEM '/etc/hostname'>", "&e;<g id='&e;'/>"),
            "left out: 2 entity: is not in this file, the first: \"e\"");
  EXPECT_EQ(notes("<!ENTITY e PUBLIC 'x' 'y'><!ENTITY e 'later'>", "&e;"),
            "left out: 1 entity: is not in this file, \"e\"");
  EXPECT_EQ(notes("", "&nowhere;"), "left out: 1 entity: is not declared, \"nowhere\"");
  EXPECT_EQ(notes("<!ENTITY e 'x'>", "&e;&lt;&gt;&amp;&quot;&apos;&#65; & &e &;"), "");
}

TEST(XmlEntities, LeavePlacesOfErrorsAsTheyAreInTheFile) {
  const auto place = [](const std::string& content) {
    const std::string message = message_of([&] {
      (void)read_all(with(
          "<!ENTITY long '" + repeated("<g/>\n", 9) + "'>" + "<!ENTITY bad '<g/>\n\n<circle r=\"big\"/>'>", content));
    });
    return message.substr(0, message.find(", attribute"));
  };
  const std::string start = "shape.svg: line ";
  EXPECT_EQ(place("\n<circle r='big'/>"), start + "14, column 2, <circle>");
  EXPECT_EQ(place("&long;\n<circle r='big'/>"), start + "14, column 2, <circle>");
  EXPECT_EQ(place("&long;&long;\n\n  <circle r='big'/>"), start + "15, column 4, <circle>");
  EXPECT_EQ(place("\n&long;\n &bad; <circle r='big'/>"), start + "15, column 2, entity \"bad\", <circle>");
  EXPECT_EQ(message_of([&] { (void)read_all(with(LINE, "\n&line;\n<g></h>")); }),
            "shape.svg: line 4, column 6: XML: Start-end tags mismatch");
}

TEST(XmlEntities, ThatWouldNotEndAreRefused) {
  const auto message = [](const std::string& declarations) {
    return message_of([&] { (void)read_all(with(declarations, "<line x2='1'/>&a;")); });
  };
  const std::string place = "shape.svg: line 2, column 56, entity ";
  const std::string itself = "expected an entity that does not contain itself";
  EXPECT_EQ(message("<!ENTITY a '&a;'>"), place + "\"a\": " + itself);
  EXPECT_EQ(message("<!ENTITY a '&b;'><!ENTITY b '<g id=\"&a;\"/>'>"), place + "\"a\": " + itself);
  EXPECT_EQ(message("<!ENTITY a '<g id=\"'>"), place + "\"a\": expected whole elements, found part of a tag");
  std::string chain = "<!ENTITY a '&e0;'>";
  for (int i = 0; i < 100; ++i) chain += "<!ENTITY e" + std::to_string(i) + " '&e" + std::to_string(i + 1) + ";'>";
  EXPECT_NE(message(chain).find("expected entities nested at most 64 levels deep"), std::string::npos);
}

// Ten times as many at each of thirty levels: of a byte, of nothing at all, and in attributes.
TEST(XmlEntities, ThatGrowWithoutBoundAreRefused) {
  for (const char* innermost : {"x", ""})
    for (const char* content : {"&a30;", "<g id='&a30;'/>"}) {
      std::string declarations = "<!ENTITY a0 '" + std::string(innermost) + "'>";
      for (int i = 1; i <= 30; ++i)
        declarations +=
            "<!ENTITY a" + std::to_string(i) + " '" + repeated("&a" + std::to_string(i - 1) + ";", 10) + "'>";
      const std::string message = message_of([&] { (void)read_all(with(declarations, content)); });
      EXPECT_NE(message.find("expected at most 67108864 bytes of SVG added by entities"), std::string::npos) << message;
    }
}

// Whatever the declaration is cut to, or has in it, is read or reported.
TEST(XmlEntities, SurviveDamage) {
  const std::string whole =
      with("<!--x--><!ENTITY % p '&#37;'><!ENTITY a \"M0 0h1\"><!ENTITY b '<path d=\"&a;\"/>'>", "&b;<g id='&a;'/>");
  EXPECT_EQ(names(whole).size(), 1u);
  for (std::size_t i = 0; i < whole.size(); ++i) {
    message_of([&] { (void)read_all(whole.substr(0, i)); });
    for (const char c : {'&', ';', '<', '>', '"', '\'', '[', ']', '-', '\xFF'}) {
      std::string damaged = whole;
      damaged[i] = c;
      message_of([&] { (void)read_all(damaged); });
    }
  }
}

}  // namespace
}  // namespace test_xml_entities
