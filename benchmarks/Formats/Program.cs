using System.Globalization;
using DuckDB.NET.Data;

// formats ROWS.parquet ROWS.csv: prints the number of rows, and the number of rows with any difference. Exit code 1 if there is one.
if (args.Length != 2)
{
    Console.Error.WriteLine("formats ROWS.parquet ROWS.csv");
    return 2;
}

using var database = new DuckDBConnection("DataSource=:memory:");
database.Open();
using DuckDBCommand command = database.CreateCommand();
string parquet = $"read_parquet('{args[0]}')";
// Read all columns as text, then convert each to the type in Parquet: CSV numbers are exact to the last bit, and an empty cell is NaN.
string csv = $"read_csv('{args[1]}', header = true, all_varchar = true)";
List<string> columns = [];
command.CommandText = $"select column_name, column_type from (describe select * from {parquet})";
using (DuckDBDataReader reader = command.ExecuteReader())
{
    while (reader.Read())
    {
        string name = $"\"{reader.GetString(0)}\"";
        string type = reader.GetString(1);
        string parsed = $"try_cast(nullif(c.{name}, '') as {type})";
        columns.Add(type == "DOUBLE"
            ? $"coalesce(p.{name}, 'nan'::double) is distinct from coalesce({parsed}, 'nan'::double)"
            : $"p.{name} is distinct from {(type == "VARCHAR" ? $"c.{name}" : parsed)}");
    }
}

command.CommandText = $"select count(*), count(*) filter (where {string.Join(" or ", columns)}) from {parquet} p positional join {csv} c";
using (DuckDBDataReader reader = command.ExecuteReader())
{
    reader.Read();
    long rows = reader.GetInt64(0);
    long different = reader.GetInt64(1);
    Console.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{rows} rows, {columns.Count} columns, {different} rows differ"));
    return different == 0 ? 0 : 1;
}
