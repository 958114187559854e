using UnityEditor;
using UnityEditor.Build;
using UnityEditor.Build.Reporting;
using UnityEngine;

namespace FootballPhysics.Unity.Editor
{
    /// <summary>Warns before a build about settings that make the ball several times slower.</summary>
    public sealed class FootballBuildCheck : IPreprocessBuildWithReport
    {
        /// <inheritdoc/>
        public int callbackOrder => 0;

        /// <inheritdoc/>
        public void OnPreprocessBuild(BuildReport report)
        {
            NamedBuildTarget target = NamedBuildTarget.FromBuildTargetGroup(report.summary.platformGroup);
#if UNITY_2022_1_OR_NEWER
            Il2CppCodeGeneration generation = PlayerSettings.GetIl2CppCodeGeneration(target);
#else
            Il2CppCodeGeneration generation = EditorUserBuildSettings.il2CppCodeGeneration;
#endif
            if (PlayerSettings.GetScriptingBackend(target) == ScriptingImplementation.IL2CPP && generation == Il2CppCodeGeneration.OptimizeSize)
            {
                Debug.LogWarning("Football Physics: IL2CPP's code generation \"Faster (smaller) builds\" compiles one shared body for all generic code, and the library's laws and methods are generic: "
                    + "steps of the ball are several times slower. Choose \"Faster runtime\" in the build settings of players that are released.");
            }
        }
    }
}
