using System;
using System.Linq;
using System.Xml.Linq;
using UnityEditor;
using UnityEngine;

namespace FootballPhysics.Unity.Editor
{
    /// <summary>The library's documentation of a preset, with the source of each number.</summary>
    public static class FootballNotes
    {
        private const string Documentation = "Packages/com.football.physics/Plugins/Football.Physics.xml";

        private static XDocument s_documentation;

        /// <summary>Returns the summary and the remarks of a preset; empty if the documentation is not available.</summary>
        /// <param name="type">The class of the preset: "BallProperties", "Ground".</param>
        /// <param name="name">The name of the preset.</param>
        public static string Of(string type, string name)
        {
            if (s_documentation == null)
            {
                var file = AssetDatabase.LoadAssetAtPath<TextAsset>(Documentation);
                if (file == null)
                {
                    return "";
                }

                s_documentation = XDocument.Parse(file.text);
            }

            string member = "P:FootballPhysics." + type + "." + name;
            XElement found = s_documentation.Descendants("member").FirstOrDefault(item => (string)item.Attribute("name") == member);
            return found == null ? "" : string.Join(" ", new[] { found.Element("summary"), found.Element("remarks") }
                .Where(part => part != null)
                .SelectMany(part => Text(part).Split(new[] { ' ', '\n', '\r', '\t' }, StringSplitOptions.RemoveEmptyEntries)));
        }

        /// <summary>Returns the text of an element, with the last part of each referenced name.</summary>
        private static string Text(XElement element)
        {
            return string.Concat(element.Nodes().Select(node => node is XElement inner ? Name((string)inner.Attribute("cref")) + inner.Value : node.ToString()));
        }

        private static string Name(string reference)
        {
            return reference == null ? "" : reference.Substring(reference.LastIndexOf('.') + 1);
        }
    }
}
