using UnityEngine;
#if ENABLE_INPUT_SYSTEM && FOOTBALL_INPUT_SYSTEM
using UnityEngine.InputSystem;
#endif

namespace FootballPhysics.Unity
{
    /// <summary>The state of the mouse and one key, from the input system of the project.</summary>
    internal static class FootballPointer
    {
#if ENABLE_INPUT_SYSTEM && FOOTBALL_INPUT_SYSTEM
        /// <summary>The position of the pointer, pixels.</summary>
        public static Vector2 Position => Mouse.current != null ? Mouse.current.position.ReadValue() : default;

        /// <summary>True while the left button is held.</summary>
        public static bool Left => Mouse.current != null && Mouse.current.leftButton.isPressed;

        /// <summary>True while the right button is held.</summary>
        public static bool Right => Mouse.current != null && Mouse.current.rightButton.isPressed;

        /// <summary>True in the frame in which R is pressed.</summary>
        public static bool Again => Keyboard.current != null && Keyboard.current.rKey.wasPressedThisFrame;
#else
        /// <summary>The position of the pointer, pixels.</summary>
        public static Vector2 Position => new Vector2(Input.mousePosition.x, Input.mousePosition.y);

        /// <summary>True while the left button is held.</summary>
        public static bool Left => Input.GetMouseButton(0);

        /// <summary>True while the right button is held.</summary>
        public static bool Right => Input.GetMouseButton(1);

        /// <summary>True in the frame in which R is pressed.</summary>
        public static bool Again => Input.GetKeyDown(KeyCode.R);
#endif
    }
}
