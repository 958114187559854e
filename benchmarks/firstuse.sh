#!/usr/bin/env bash
# Measures the first use of each feature in a process, in a program of a few lines that uses the package. Prints a table in Markdown.
#   benchmarks/firstuse.sh
# The same, and compiled just in time without a package: dotnet run -c Release --project benchmarks/Football.Physics.Benchmarks -- quick --only "first use"
. "$(dirname "${BASH_SOURCE[0]}")/publish.sh"
version=0.1.0-local.$(date -u +%Y%m%d%H%M%S)
table=$PWD/benchmarks/Football.Physics.Benchmarks
mkdir "$work/app"
cat > "$work/app/app.csproj" << END
<Project Sdk="Microsoft.NET.Sdk">
  <PropertyGroup>
    <OutputType>Exe</OutputType>
    <TargetFramework>net10.0</TargetFramework>
    <ImplicitUsings>enable</ImplicitUsings>
    <Nullable>enable</Nullable>
  </PropertyGroup>
  <ItemGroup>
    <PackageReference Include="Football.Physics" Version="$version" />
    <Using Include="FootballPhysics;FootballPhysics.Aiming;FootballPhysics.Batch;FootballPhysics.Prediction" />
    <Compile Include="$table/Quick/FirstUseTable.cs;$table/Quick/Child.cs;$table/Quick/Text.cs" />
  </ItemGroup>
</Project>
END
cat > "$work/app/Program.cs" << 'END'
using FootballPhysics.Benchmarks;

if (args is ["quick", "--child", "first", var warm])
{
    Console.WriteLine(FirstUseTable.Measure(warm == "1"));
}
else
{
    FirstUseTable.Print(Console.WriteLine);
}
END
{
  dotnet pack src/Packages.proj -c Release -o "$work/feed" "-p:Version=$version" -p:PackReadyToRun=true -p:RunAnalyzers=false
  NUGET_PACKAGES=$work/cache dotnet build "$work/app" -c Release --source "$work/feed" -o "$work/out"
} > "$work/log" 2>&1 || { tail -n 5 "$work/log" >&2; exit 1; }
"$work/out/app"
