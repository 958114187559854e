// No local is read before it is written, and none is made from the stack unsafely: zeroing the step's structs would cost a tenth of it.
[module: System.Runtime.CompilerServices.SkipLocalsInit]
