using System;

namespace UnityEngine
{
    public class YieldInstruction
    {
    }

    public sealed class WaitForFixedUpdate : YieldInstruction
    {
    }
}

namespace UnityEngine.TestTools
{
    [AttributeUsage(AttributeTargets.Method)]
    public sealed class UnityTestAttribute : Attribute
    {
    }
}

namespace NUnit.Framework
{
    [AttributeUsage(AttributeTargets.Method)]
    public sealed class TearDownAttribute : Attribute
    {
    }

    /// <summary>As much of NUnit as the package's own tests use.</summary>
    public static class Assert
    {
        public static void AreEqual(object expected, object actual)
        {
            if (!Equals(expected, actual))
            {
                throw new InvalidOperationException("Expected " + expected + ", but was " + actual + ".");
            }
        }

        public static void Less(float arg1, float arg2)
        {
            if (!(arg1 < arg2))
            {
                throw new InvalidOperationException("Expected less than " + arg2 + ", but was " + arg1 + ".");
            }
        }

        public static void IsTrue(bool condition)
        {
            if (!condition)
            {
                throw new InvalidOperationException("Expected true.");
            }
        }
    }
}
